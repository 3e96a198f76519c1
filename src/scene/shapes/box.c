/* SPDX-License-Identifier: MIT */
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

/* From centre and side. */
static const char *corner_cube(rt_element *element)
{
    sure_vec3 centre = element->position;
    double half = element->diameter / 2;
    element->position = (sure_vec3){centre.x - half, centre.y - half, centre.z - half};
    element->axis = (sure_vec3){centre.x + half, centre.y + half, centre.z + half};
    bool is_finite = isfinite(element->position.x + element->position.y + element->position.z) &&
                     isfinite(element->axis.x + element->axis.y + element->axis.z);
    return is_finite ? NULL : "a cube without finite corners is left out";
}

/* Along its axis and across it; only those that stand upright are boxes. */
static const char *stand_cube(rt_element *element)
{
    const sure_vec3 axis = element->axis;
    if ((axis.x != 0) + (axis.y != 0) + (axis.z != 0) > 1)
        return "a cube that stands askew is left out";
    return corner_cube(element);
}

#define SIDE RT_AT(NUMBER, diameter, "side", "a number above 0", 0, INFINITY, true)

const rt_shape rt_box = {
    .words = {"bo"},
    .fields = {RT_POSITION, RT_AT(POINT, axis, "opposite corner", "x,y,z")},
    .forms = {{.words = {"bx", "box"},
               .fields = {RT_POSITION, RT_AT(POINT, axis, "opposite corner", "x,y,z")},
               .guess = "a box by another name is read as 'bo', by two opposite corners"},
              {.words = {"cu", "cb", "cube"},
               .fields = {RT_POSITION, SIDE},
               .guess = "a cube is read as centre and side",
               .take = corner_cube},
              {.words = {"cu", "cb", "cube"},
               .fields = {RT_POSITION, RT_TOWARDS("axis"), SIDE},
               .guess = "a cube is read as centre, axis and side",
               .take = stand_cube}},
    .place = place,
};
