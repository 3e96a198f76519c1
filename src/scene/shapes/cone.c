/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

#include "../placement.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    sure_cone *cone = &object->as.cone;
    sure_vec3 axis = element->axis;
    if (options->cone_position == RT_POSITION_APEX) /* it opens along the axis */
        axis = (sure_vec3){-axis.x, -axis.y, -axis.z};
    cone->radius = element->diameter / 2;
    return rt_ends(options->cone_position, element, axis, &cone->base, &cone->apex);
}

/* A cone without an end, of which the angle at the apex is told: it gets one, far away. */
static const char *end_cone(rt_element *element)
{
    element->height = 1024;
    element->diameter = viewport_extent(element->height, 2 * element->diameter);
    return element->diameter > 0 ? NULL : "a cone whose half-angle rounds to 0 is left out";
}

#define CONES                                                                                      \
    {                                                                                              \
        "co", "cn", "con", "cone"                                                                  \
    }

const rt_shape rt_cone = {
    .words = CONES,
    .fields = {RT_POSITION, RT_TOWARDS("axis"), RT_SIZE_OF(diameter), RT_SIZE_OF(height)},
    .forms = {{.words = CONES,
               .fields = {RT_POSITION, RT_TOWARDS("axis"),
                          RT_AT(NUMBER, diameter, "half-angle", "degrees above 0 and below 90", 0,
                                90, true)},
               .guess = "a cone of one number: a half-angle in degrees; it is drawn 1024 high",
               .take = end_cone}},
    .place = place,
};
