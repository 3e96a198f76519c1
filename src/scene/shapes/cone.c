#include "rt_shape.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    sure_cone *cone = &object->as.cone;
    sure_vec3 axis = element->axis;
    if (options->cone_position == RT_POSITION_APEX) /* it opens along the axis */
        axis = (sure_vec3){-axis.x, -axis.y, -axis.z};
    cone->radius = element->diameter / 2;
    return rt_ends(options->cone_position, element, axis, &cone->base, &cone->apex);
}

const rt_shape rt_cone = {
    .words = {"co", "cn", "con", "cone"},
    .fields = {RT_POSITION, RT_TOWARDS("axis"), RT_SIZE_OF(diameter), RT_SIZE_OF(height)},
    .place = place,
};
