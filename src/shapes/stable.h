/* SPDX-License-Identifier: MIT */
/* The tier stable of the shapes: the first stage of certain alone and, where it is uncertain, a
 * guess. */
#pragma once

#include "../stages/stages.h"
#include "span.h"

/* A shape's interval as doubles have it. */
typedef span stable_guess(const sure_ray *ray, const void *shape);

/* Where the first stage is uncertain of the ray as it is asked. Entry: any input. */
sure_status stable_rest_of_hit(const shape_row *row, stable_guess *guess, const sure_ray *ray,
                               const void *shape, sure_hit *hit);

/* The whole question: few ask it, so it is one function. */
sure_status stable_interval(const shape_row *row, stable_guess *guess, const sure_ray *ray,
                            const void *shape, sure_interval *interval);

static INLINED sure_status stable_hit(const shape_row *row, first_stage *filter,
                                      stable_guess *guess, const sure_ray *ray, const void *shape,
                                      sure_hit *hit)
{
    filter_interval found;
    filter_end first;
    filter_verdict verdict = stages_first(filter, ray, shape, &found, &first);
    if (verdict == FILTER_MISS)
        return SURE_MISS;
    if (verdict == FILTER_INTERVAL) {
        *hit = filter_hit(&found, &first);
        return SURE_HIT;
    }
    return stable_rest_of_hit(row, guess, ray, shape, hit);
}

#define STABLE_QUESTIONS(shape)                                                                    \
    sure_status sure_##shape##_hit_stable(const sure_ray *ray, const sure_##shape *s,              \
                                          sure_hit *hit)                                           \
    {                                                                                              \
        return stable_hit(&shape##_row, shape##_filter, shape##_guess, ray, s, hit);               \
    }                                                                                              \
    sure_status sure_##shape##_interval_stable(const sure_ray *ray, const sure_##shape *s,         \
                                               sure_interval *interval)                            \
    {                                                                                              \
        return stable_interval(&shape##_row, shape##_guess, ray, s, interval);                     \
    }                                                                                              \
    sure_status sure_##shape##_occluded_stable(const sure_ray *ray, const sure_##shape *s)         \
    {                                                                                              \
        sure_hit unused;                                                                           \
        return sure_##shape##_hit_stable(ray, s, &unused);                                         \
    }
