/* SPDX-License-Identifier: MIT */
/* What planar parts share in the stages after the first. */
#pragma once

#include "../../stages/last/line.h"
#include "../../stages/stages.h"
#include "planar_exact.h"

/* The ray's line seen from a point of the plane, and h = N.m; e is the line's speed. */
typedef struct {
    vector_exact m, d;
    exact h;
} planar_line;

static inline planar_line planar_line_of(exact_context *c, const sure_ray *ray, sure_vec3 point,
                                         sure_vec3 normal, line_coefficients *l)
{
    planar_line at = {.m = vector_between_exact(c, point, ray->origin),
                      .d = vector_of_exact(c, ray->direction)};
    vector_exact n = vector_of_exact(c, normal);
    at.h = vector_dot_exact(c, n, at.m);
    l->speed = vector_dot_exact(c, n, at.d);
    l->base = exact_negate(c, at.h);
    return at;
}

/* A chord that is boundary, of that part between its ends: who starts there is there already. */
static inline filter_verdict planar_chord(sure_part part, const sure_ray *ray, bool both_ends,
                                          filter_interval *found)
{
    const filter_end start = {.end = {END_START, part}};
    if (both_ends || found->enter.t - ray->t_min > found->enter.error ||
        ray->t_min - found->leave.t > found->leave.error)
        return FILTER_INTERVAL;
    if (!(bits_of(ray->t_min) == 0 && -found->enter.t > found->enter.error &&
          found->leave.t > found->leave.error))
        return FILTER_UNCERTAIN;
    *found = (filter_interval){start, start};
    return FILTER_INTERVAL;
}

/* The structs of plane and disc begin with a point and the normal. */
static inline sure_vec3 planar_round_normal(exact_context *c, const sure_ray *ray,
                                            const void *shape, const line_coefficients *l,
                                            tagged_end at)
{
    (void)ray, (void)l, (void)at;
    return round_unit(c, vector_of_exact(c, ((const sure_vec3 *)shape)[1]));
}
