/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    sure_cylinder *cylinder = &object->as.cylinder;
    cylinder->radius = element->diameter / 2;
    return rt_ends(options->cylinder_position, element, element->axis, &cylinder->base,
                   &cylinder->top);
}

const rt_shape rt_cylinder = {
    .words = {"cy"},
    .fields = {RT_POSITION, RT_TOWARDS("axis"), RT_SIZE_OF(diameter), RT_SIZE_OF(height)},
    .forms = {{.words = {"cylinder", "cyl"},
               .fields = {RT_POSITION, RT_TOWARDS("axis"), RT_SIZE_OF(diameter),
                          RT_SIZE_OF(height)},
               .guess = "a cylinder by another name is read as 'cy'"}},
    .place = place,
};
