/* SPDX-License-Identifier: MIT */
#include "case_floats.h"

#include <string.h>

/* The functions of a shape, by tier. */
#define OF_TIER(shape, tier)                                                                       \
    static sure_status shape##_hit_##tier(const float_query *q, sure_hit_f *hit)                   \
    {                                                                                              \
        return sure_##shape##_hit_##tier##_f(&q->ray, (const void *)q->object, hit);               \
    }                                                                                              \
    static sure_float_vec3 shape##_normal_##tier(const float_query *q, const sure_hit_f *hit)      \
    {                                                                                              \
        return sure_##shape##_normal_##tier##_f(&q->ray, (const void *)q->object, hit);            \
    }
#define OF_SHAPE(shape, SHAPE)                                                                     \
    OF_TIER(shape, certain)                                                                        \
    OF_TIER(shape, exact)                                                                          \
    static sure_field shape##_check(const float_query *q)                                          \
    {                                                                                              \
        return sure_##shape##_check_f(&q->ray, (const void *)q->object);                           \
    }
SURE_EACH_SHAPE(OF_SHAPE)

typedef struct {
    sure_field (*check)(const float_query *);
    sure_status (*hit[2])(const float_query *, sure_hit_f *);
    sure_float_vec3 (*normal[2])(const float_query *, const sure_hit_f *);
} float_functions;

#define ROW(shape, SHAPE)                                                                          \
    {shape##_check,                                                                                \
     {shape##_hit_certain, shape##_hit_exact},                                                     \
     {shape##_normal_certain, shape##_normal_exact}},
static const float_functions functions[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};

float_query float_query_of(const sure_case *rounded)
{
    double numbers[CASE_NUMBERS_MAX];
    float narrow[CASE_NUMBERS_MAX];
    float_query q = {.shape = rounded->object.shape};
    int count = case_numbers(q.shape);
    case_to_numbers(rounded, numbers);
    for (int i = 0; i < count; i++)
        narrow[i] = (float)numbers[i];
    memcpy(&q.ray, narrow, sizeof q.ray);
    memcpy(q.object, narrow + AT_OBJECT, (size_t)(count - AT_OBJECT) * sizeof *narrow);
    return q;
}

sure_field float_query_check(const float_query *q)
{
    return functions[q->shape].check(q);
}

sure_status float_query_hit(const float_query *q, sure_tier tier, sure_hit_f *hit)
{
    return functions[q->shape].hit[tier == SURE_TIER_EXACT](q, hit);
}

sure_float_vec3 float_query_normal(const float_query *q, sure_tier tier, const sure_hit_f *hit)
{
    return functions[q->shape].normal[tier == SURE_TIER_EXACT](q, hit);
}
