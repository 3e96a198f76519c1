/* SPDX-License-Identifier: MIT */
/* certain_f and exact_f. A float is a double, so the stages decide as they do for doubles; t, which
 * they know to many more digits than a float has, is rounded at the end. The first stage is inlined
 * into the public functions (shapes/floats.c); hits/floats.c has the rest. docs/proofs/floats.md.
 */
#pragma once

#include "../numbers/flushing.h"
#include "stages.h"

#include <surehit/floats.h>

/* From the first stage on, in any environment. */
sure_status floats_rest_of_hit(const sure_ray_f *ray, const void *shape, sure_hit_f *hit,
                               sure_shape which);
sure_field floats_check(const sure_ray_f *ray, const void *shape, sure_shape which);
sure_float_vec3 floats_normal(const sure_ray_f *ray, const void *shape, const sure_hit_f *hit,
                              sure_shape which, sure_tier tier);

/* Structs of so many floats and doubles, in their order. */
#ifdef __GNUC__
#define FLOATS_ONE_BY_ONE _Pragma("GCC unroll 8")
#else
#define FLOATS_ONE_BY_ONE
#endif
static INLINED void floats_widen(const void *from, size_t count, void *to)
{
    const float *number = (const float *)from;
    double *wide = (double *)to;
    FLOATS_ONE_BY_ONE
    for (size_t i = 0; i < count; i++)
        wide[i] = number[i];
}

/* The float that t* rounds to, where its error does not matter. Entry: the default environment, |t
 * - t*| <= error <= t. */
static inline bool floats_round(double t, double error, float *rounded)
{
    double off = filter_float_off(t, error);
    *rounded = (float)(t - off);
    return *rounded == (float)(t + off);
}

static inline uint32_t floats_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* hit_where (numbers/hit.h) of floats. */
static inline void floats_hit_where(bool met, sure_hit_f answer, sure_hit_f *hit)
{
    const uint32_t mask = -(uint32_t)met;
    const uint32_t t = (floats_bits(answer.t) & mask) | (floats_bits(hit->t) & ~mask);
    memcpy(&hit->t, &t, sizeof t);
    hit->part = (sure_part)(((unsigned)answer.part & mask) | ((unsigned)hit->part & ~mask));
    hit->leaves = (int)(((unsigned)answer.leaves & mask) | ((unsigned)hit->leaves & ~mask));
}

/* What the first stage says, as an answer. decided: for certain; meets: and that is a hit, `found`.
 */
static INLINED sure_status floats_answer(bool decided, bool meets, const sure_hit *found,
                                         const sure_ray_f *ray, const void *shape, sure_hit_f *hit,
                                         sure_shape which)
{
    float t;
    bool rounds = floats_round(found->t, found->t_error, &t);
    if (!(decided & (!meets | rounds) & environment_is_default()))
        return floats_rest_of_hit(ray, shape, hit, which);
    floats_hit_where(meets, (sure_hit_f){t, found->part, found->leaves}, hit);
    return meets ? SURE_HIT : SURE_MISS;
}

/* Of a solid: its first stage, and what that says. */
static INLINED sure_status floats_hit_solid(first_stage *filter, const sure_ray *wide,
                                            const void *wide_shape, const sure_ray_f *ray,
                                            const void *shape, sure_hit_f *hit, sure_shape which)
{
    filter_interval found;
    filter_end first;
    sure_hit at = {.t = 0};
    filter_verdict verdict = stages_first(filter, wide, wide_shape, &found, &first);
    if (verdict == FILTER_MISS && environment_is_default())
        return SURE_MISS;
    if (verdict == FILTER_INTERVAL)
        at = filter_hit(&found, &first);
    return floats_answer(verdict == FILTER_INTERVAL, true, &at, ray, shape, hit, which);
}
