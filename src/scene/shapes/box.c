#include "rt_shape.h"

static bool is_along_axes(const sure_mat3 *turn)
{
    for (int i = 0; i < 3; i++) {
        const sure_vec3 *row = &turn->row[i];
        if ((row->x != 0) + (row->y != 0) + (row->z != 0) != 1)
            return false;
    }
    return true;
}

static void sort(double *low, double *high)
{
    double least = fmin(*low, *high);
    *high = fmax(*low, *high);
    *low = least;
}

/* Two opposite corners, any. A box that the camera sees turned is none. */
static const char *place(const rt_element *element, const rt_placing *how, sure_object *object)
{
    sure_vec3 low = element->position, high = element->axis;
    if (!is_along_axes(how->turn))
        return "turned; expected a camera that looks along an axis";
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
