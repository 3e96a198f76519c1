/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    (void)options;
    object->as.sphere = (sure_sphere){element->position, element->diameter / 2};
    return NULL;
}

const rt_shape rt_sphere = {
    .words = {"sp"},
    .fields = {RT_POSITION, RT_SIZE_OF(diameter)},
    .forms = {{.words = {"sphere", "sph"},
               .fields = {RT_POSITION, RT_SIZE_OF(diameter)},
               .guess = "a sphere by another name is read as 'sp'"}},
    .place = place,
};
