/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

static const char *place(const rt_element *element, const rt_options *options, sure_object *object)
{
    (void)options;
    object->as.plane = (sure_plane){element->position, element->axis};
    return NULL;
}

const rt_shape rt_plane = {
    .words = {"pl"},
    .fields = {RT_POSITION, RT_TOWARDS("normal")},
    .forms = {{.words = {"plane", "pla"},
               .fields = {RT_POSITION, RT_TOWARDS("normal")},
               .guess = "a plane by another name is read as 'pl'"}},
    .place = place,
};
