/* SPDX-License-Identifier: MIT */
/* certain and exact as a list of stages: the first one here, so that it is inlined into each
 * shape's public functions; the rest in stages.c. docs/proofs/stages.md. */
#pragma once

#include "../numbers/environment.h"
#include "shape.h"

/* The stages after the first, for a hit and for both ends. Entry: any input. The first three
 * arguments are those of the public functions, in their registers. */
sure_status stages_rest_of_hit(const sure_ray *ray, const void *shape, sure_hit *hit,
                               const shape_row *row, t_wanted wanted, sure_stage *stage);
/* certain's stages from the first one on, where a quick look at the shape was not enough. */
sure_status stages_certain_hit(const sure_ray *ray, const void *shape, sure_hit *hit,
                               const shape_row *row);
/* From the second one on, where the first can't tell. */
sure_status stages_certain_rest(const sure_ray *ray, const void *shape, sure_hit *hit,
                                const shape_row *row);
/* Is there a hit? All stages. */
sure_status stages_occluded(const sure_ray *ray, const void *shape, const shape_row *row);
sure_status stages_rest_of_interval(const sure_ray *ray, const void *shape, sure_interval *interval,
                                    const shape_row *row, t_wanted wanted);

/* The last stage alone: exact integers. Entry: valid input. Only a hit sets what is asked for. */
sure_status stages_last_hit(const shape_row *row, const sure_ray *ray, const void *shape,
                            t_wanted wanted, sure_hit *hit);
sure_status stages_last_interval(const shape_row *row, const sure_ray *ray, const void *shape,
                                 sure_interval *interval);

/* Half the step from t to its neighbour away from zero, or the least double. */
static inline double half_ulp(double t)
{
    int exponent = exponent_of(t);
    if (!is_finite_bits(t))
        return INFINITY;
    if (exponent > -969)
        return power_of_two(exponent - 53);
    return double_of(exponent < -1021 ? 1 : UINT64_C(1) << (exponent + 1021));
}

/* Two ends that lie closer than they are known may come out in the wrong order; then the first is
 * an approximation of both, as good as the worse of the two: enter* <= leave*, and enter* is no
 * farther below it than from t_enter, leave* no farther above it than from t_leave. */
static inline void stages_order_ends(sure_interval *interval)
{
    if (interval->t_leave < interval->t_enter)
        interval->t_leave = interval->t_enter;
}

/* The first stage: the first end in the range, where it is certain. */
static INLINED filter_verdict stages_first(first_stage *filter, const sure_ray *ray,
                                           const void *shape, filter_interval *found,
                                           filter_end *first)
{
    filter_verdict verdict = filter(ray, shape, found);
    return verdict == FILTER_INTERVAL ? filter_first(found, ray, first) : verdict;
}

/* The list of stages. 1. Doubles with proven bounds, and for `exact` a step of Newton's method with
 * the residual in double-doubles; then stages.c. */
static INLINED sure_status stages_hit(const shape_row *row, const sure_ray *ray, const void *shape,
                                      t_wanted wanted, sure_hit *hit, sure_stage *stage)
{
    filter_interval found;
    filter_end first;
    double t;
    filter_verdict verdict = stages_first(row->filter, ray, shape, &found, &first);
    *stage = SURE_STAGE_DOUBLE;
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_INTERVAL && wanted == T_CERTAIN) {
        *hit = filter_hit(&found, &first);
        return SURE_HIT;
    }
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
    if (verdict == FILTER_INTERVAL && close_polish(row, ray, shape, &first, &t)) {
        *hit = filter_hit(&found, &first);
        hit->t = t;
        hit->t_error = half_ulp(t);
        return SURE_HIT;
    }
    return stages_rest_of_hit(ray, shape, hit, row, wanted, stage);
}

/* The same for both ends. */
static INLINED sure_status stages_interval(const shape_row *row, const sure_ray *ray,
                                           const void *shape, t_wanted wanted,
                                           sure_interval *interval)
{
    filter_interval found;
    double enter, leave;
    filter_verdict verdict = row->filter(ray, shape, &found);
    if (verdict == FILTER_INTERVAL)
        verdict = filter_meets(&found, ray);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_INTERVAL && wanted == T_CERTAIN) {
        *interval = (sure_interval){found.enter.t, found.leave.t, found.enter.end.part,
                                    found.leave.end.part};
        stages_order_ends(interval);
        return SURE_HIT;
    }
    if (verdict == FILTER_INTERVAL && close_polish(row, ray, shape, &found.enter, &enter) &&
        close_polish(row, ray, shape, &found.leave, &leave)) {
        *interval = (sure_interval){enter, leave, found.enter.end.part, found.leave.end.part};
        return SURE_HIT;
    }
    return stages_rest_of_interval(ray, shape, interval, row, wanted);
}

/* What else is public of a shape by its row than sure_<shape>_hit_certain. */
#define STAGES_QUESTIONS(shape)                                                                    \
    sure_field sure_##shape##_check(const sure_ray *ray, const sure_##shape *s)                    \
    {                                                                                              \
        return shape_check(&shape##_row, ray, s);                                                  \
    }                                                                                              \
    sure_status sure_##shape##_hit_exact(const sure_ray *ray, const sure_##shape *s,               \
                                         sure_hit *hit)                                            \
    {                                                                                              \
        sure_stage unused;                                                                         \
        return stages_hit(&shape##_row, ray, s, T_EXACT, hit, &unused);                            \
    }                                                                                              \
    sure_status sure_##shape##_interval_certain(const sure_ray *ray, const sure_##shape *s,        \
                                                sure_interval *interval)                           \
    {                                                                                              \
        return stages_interval(&shape##_row, ray, s, T_CERTAIN, interval);                         \
    }                                                                                              \
    sure_status sure_##shape##_interval_exact(const sure_ray *ray, const sure_##shape *s,          \
                                              sure_interval *interval)                             \
    {                                                                                              \
        return stages_interval(&shape##_row, ray, s, T_EXACT, interval);                           \
    }                                                                                              \
    sure_status sure_##shape##_occluded_certain(const sure_ray *ray, const sure_##shape *s)        \
    {                                                                                              \
        sure_hit unused;                                                                           \
        return sure_##shape##_hit_certain(ray, s, &unused);                                        \
    }                                                                                              \
    sure_status sure_##shape##_occluded_exact(const sure_ray *ray, const sure_##shape *s)          \
    {                                                                                              \
        return stages_occluded(ray, s, &shape##_row);                                              \
    }
