/* SPDX-License-Identifier: MIT */
/* Tier float32 of what is rounded before: part of that tier's variant alone. */
#include "span.h"

#include <assert.h>

void sure_float_ray_of(const sure_ray *ray, sure_float_ray *rounded)
{
    span_round(ray, sizeof *ray / sizeof(double), (void *)rounded);
    rounded->of = ray;
}

void sure_float_object_of(const sure_object *object, sure_float_object *rounded)
{
    span_round(&object->as, (size_t)sure_shape_info_of(object->shape)->numbers, rounded->numbers);
    rounded->shape = object->shape;
    rounded->of = object;
}

sure_status sure_float_object_hit(const sure_float_ray *ray, const sure_float_object *object,
                                  sure_hit *hit)
{
#define ROUNDED_HIT(shape, SHAPE) shape##_rounded_hit,
    static span_rounded_hit *const hits[SURE_SHAPES] = {SURE_EACH_SHAPE(ROUNDED_HIT)};
    assert((unsigned)object->shape < SURE_SHAPES);
    return hits[object->shape](ray, object, hit);
}
