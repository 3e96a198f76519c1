/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    (void)options;
    object->as.disc = (sure_disc){element->position, element->axis, element->diameter / 2};
    return NULL;
}

const rt_shape rt_disc = {
    .words = {"di"},
    .fields = {RT_POSITION, RT_TOWARDS("normal"), RT_SIZE_OF(diameter)},
    .forms = {{.words = {"disc", "disk", "dk"},
               .fields = {RT_POSITION, RT_TOWARDS("normal"), RT_SIZE_OF(diameter)},
               .guess = "a disc by another name is read as 'di'"}},
    .place = place,
};
