/* SPDX-License-Identifier: MIT */
/* Cases in floats, for the library's forms that take these. */
#pragma once

#include "case.h"

#include <surehit/floats.h>

typedef struct {
    sure_shape shape;
    sure_ray_f ray;
    float object[SURE_SHAPE_NUMBERS]; /* of the shape's struct */
} float_query;

/* Entry: a case of float_case. */
float_query float_query_of(const sure_case *rounded);

/* sure_<shape>_hit_certain_f and so on. Entry: tier is certain or exact. */
sure_field float_query_check(const float_query *q);
sure_status float_query_hit(const float_query *q, sure_tier tier, sure_hit_f *hit);
sure_float_vec3 float_query_normal(const float_query *q, sure_tier tier, const sure_hit_f *hit);
