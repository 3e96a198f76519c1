#include "rt_shape.h"

static void sort(double *low, double *high)
{
    double least = fmin(*low, *high);
    *high = fmax(*low, *high);
    *low = least;
}

/* Two opposite corners, any. */
static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    (void)options;
    sure_vec3 low = element->position, high = element->axis;
    sort(&low.x, &high.x);
    sort(&low.y, &high.y);
    sort(&low.z, &high.z);
    object->as.box = (sure_box){low, high};
    return NULL;
}

const rt_shape rt_box = {
    .words = {"bo"},
    .fields = {RT_POSITION, RT_AT(POINT, axis, "opposite corner", "x,y,z")},
    .place = place,
};
