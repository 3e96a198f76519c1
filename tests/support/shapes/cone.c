/* SPDX-License-Identifier: MIT */
/* Cone. */
#include "../test_shape.h"

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_cone *s = &object->as.cone;
    (void)ray;
    return object_made(SURE_SHAPE_CONE, vector_sum(2, s->base, -1, s->apex), s->apex, s->apex,
                       2 * s->radius);
}

static true_frame frame(const sure_object *object)
{
    const sure_cone *s = &object->as.cone;
    return (true_frame){s->apex,       s->apex,        s->base,       s->radius,
                        .round = true, .capped = true, .tapers = true};
}

const test_shape test_shape_cone = {
    .through = {{{-3, -4, -8}, {-3, -4, 8}, 10}, {{-3, -4, 0}, {-3, -4, 8}, 10}},
    .companion = companion,
    .frame = frame,
    .in_object = true_in_capped,
    .long_numbers = true,
};
