/* SPDX-License-Identifier: MIT */
/* Plane. */
#include "../test_shape.h"

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_plane *s = &object->as.plane;
    (void)ray;
    return (sure_object){SURE_SHAPE_DISC, {.disc = {s->point, s->normal, 0x1p500}}};
}

static true_frame frame(const sure_object *object)
{
    const sure_plane *s = &object->as.plane;
    return (true_frame){.from = s->point, .to = s->normal, .flat = true};
}

const test_shape test_shape_plane = {
    .through = {{{-3, -4, -2}, {0, 0, 0}, 64}, {{-3, -4, -2}, {0, 0, 0}, 64}},
    .companion = companion,
    .frame = frame,
    .in_object = true_in_plane,
};
