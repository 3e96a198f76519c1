/* SPDX-License-Identifier: MIT */
/* The shapes in floats: what is public of them. */
#include "../stages/floats.h"

#include "box/box_filter.h"
#include "cone/cone_filter.h"
#include "cylinder/cylinder_filter.h"
#include "disc/disc_filter.h"
#include "plane/plane_filter.h"
#include "sphere/sphere_filter.h"

/* Of plane and disc: whether there is a hit is as good as random, so it is no branch. */
STAGES_INLINE sure_status hit_flat(flat_decision said, const sure_ray_f *ray, const void *shape,
                                   sure_hit_f *hit, sure_shape which)
{
    const sure_hit at = flat_hit_at(&said.at);
    return floats_answer(said.certain, said.meets, &at, ray, shape, hit, which);
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
#define HIT_FLAT(shape, SHAPE)                                                                     \
    HIT(shape, hit_flat(shape##_decide(&wide, &of), ray, s, hit, SURE_SHAPE_##SHAPE))
#define HIT_SOLID(shape, SHAPE)                                                                    \
    HIT(shape, floats_hit_solid(shape##_filter, &wide, &of, ray, s, hit, SURE_SHAPE_##SHAPE))
HIT_FLAT(plane, PLANE)
HIT_FLAT(disc, DISC)
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
