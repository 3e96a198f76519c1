/* SPDX-License-Identifier: MIT */
/* Cylinder. */
#include "../test_shape.h"

static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_cylinder *s = &object->as.cylinder;
    (void)ray;
    return object_made(SURE_SHAPE_CYLINDER, s->base, s->base, vector_sum(2, s->top, -1, s->base),
                       s->radius);
}

static true_frame frame(const sure_object *object)
{
    const sure_cylinder *s = &object->as.cylinder;
    return (true_frame){s->base, s->base, s->top, s->radius, .round = true, .capped = true};
}

const test_shape test_shape_cylinder = {
    .through = {{{-3, -4, -4}, {-3, -4, 8}, 5}, {{-3, -4, 0}, {-3, -4, 8}, 10}},
    .companion = companion,
    .frame = frame,
    .in_object = true_in_capped,
};
