/* SPDX-License-Identifier: MIT */
/* The shapes in floats: what is public of them. */
#include "../stages/floats.h"

#include "box/box_filter.h"
#include "cone/cone_filter.h"
#include "cylinder/cylinder_filter.h"
#include "disc/disc_lanes.h"
#include "plane/plane_lanes.h"
#include "sphere/sphere_filter.h"

/* Without a branch, where what a miss spares is less than what a wrong guess costs. */
static INLINED sure_status hit_of(lanes_answer said, const sure_ray_f *ray, const void *shape,
                                  sure_hit_f *hit, sure_shape which)
{
    const sure_hit at = {said.t, said.error, (sure_part)said.part, said.leaves};
    return floats_answer(said.certain, said.hits, &at, ray, shape, hit, which);
}

/* `wide` and `of`: ray and shape as doubles. */
#define HIT(shape, answer)                                                                         \
    sure_status sure_##shape##_hit_certain_f(const sure_ray_f *ray, const sure_##shape##_f *s,     \
                                             sure_hit_f *hit)                                      \
    {                                                                                              \
        sure_ray wide;                                                                             \
        sure_##shape of;                                                                           \
        floats_widen(ray, sizeof wide / sizeof(double), &wide);                                    \
        floats_widen(s, sizeof of / sizeof(double), &of);                                          \
        return answer;                                                                             \
    }
#define HIT_ONE(shape, SHAPE)                                                                      \
    HIT(shape, hit_of(shape##_lanes(&wide, &of), ray, s, hit, SURE_SHAPE_##SHAPE))
#define HIT_SOLID(shape, SHAPE)                                                                    \
    HIT(shape, floats_hit_solid(shape##_filter, &wide, &of, ray, s, hit, SURE_SHAPE_##SHAPE))
HIT_ONE(plane, PLANE)
HIT_ONE(disc, DISC)
HIT_SOLID(sphere, SPHERE)
HIT_SOLID(cylinder, CYLINDER)
HIT_SOLID(cone, CONE)
HIT_SOLID(box, BOX)

#define NORMAL(shape, SHAPE, tier, TIER)                                                           \
    sure_float_vec3 sure_##shape##_normal_##tier##_f(                                              \
        const sure_ray_f *ray, const sure_##shape##_f *s, const sure_hit_f *hit)                   \
    {                                                                                              \
        return floats_normal(ray, s, hit, SURE_SHAPE_##SHAPE, SURE_TIER_##TIER);                   \
    }
#define OTHERS(shape, SHAPE)                                                                       \
    sure_status sure_##shape##_hit_exact_f(const sure_ray_f *ray, const sure_##shape##_f *s,       \
                                           sure_hit_f *hit)                                        \
    {                                                                                              \
        return sure_##shape##_hit_certain_f(ray, s, hit);                                          \
    }                                                                                              \
    sure_field sure_##shape##_check_f(const sure_ray_f *ray, const sure_##shape##_f *s)            \
    {                                                                                              \
        return floats_check(ray, s, SURE_SHAPE_##SHAPE);                                           \
    }                                                                                              \
    NORMAL(shape, SHAPE, certain, CERTAIN)                                                         \
    NORMAL(shape, SHAPE, exact, EXACT)
SURE_EACH_SHAPE(OTHERS)
