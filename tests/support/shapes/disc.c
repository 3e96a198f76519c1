/* SPDX-License-Identifier: MIT */
/* Disc. */
#include "../test_shape.h"

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    (void)ray;
    return object_sided(object);
}

static true_frame frame(const sure_object *object)
{
    const sure_disc *s = &object->as.disc;
    return (true_frame){
        .from = s->centre, .to = s->normal, .radius = s->radius, .flat = true, .round = true};
}

const test_shape test_shape_disc = {
    .through = {{{-3, -4, -2}, {0, 0, 0}, 64}, {{-3, -4, -2}, {0, 0, 0}, 64}},
    .companion = companion,
    .frame = frame,
    .in_object = true_in_plane,
};
