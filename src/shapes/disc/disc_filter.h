/* SPDX-License-Identifier: MIT */
/* The first stage of the disc; docs/proofs/disc_filter.md proves it. The line crosses its plane at
 * t = -h/e (plane_filter.h), at p = m + t d from its centre. Is |p| < r? Without a division:
 *
 *     f = e m - h d = e p,  |f| < r |e|
 */
#pragma once

#include "../plane/plane_filter.h"

#include <surehit/disc.h>

/* |f|^2 against r |e|: off by at most slack together, as lengths. */
typedef struct {
    double square, rim, slack;
    bool in_range;
} disc_foot_terms;

static inline bool disc_inside(const disc_foot_terms *foot)
{
    double inner = foot->rim - foot->slack;
    return inner * fabs(inner) > foot->square;
}

static inline bool disc_outside(const disc_foot_terms *foot)
{
    double outer = foot->rim + foot->slack;
    return foot->square > outer * outer;
}

static inline disc_foot_terms disc_foot_terms_of(const flat_terms *of, const sure_ray *ray,
                                                 double r)
{
    double fx = of->e * of->mx - of->h * ray->direction.x;
    double fy = of->e * of->my - of->h * ray->direction.y;
    double fz = of->e * of->mz - of->h * ray->direction.z;
    double slack = SURE_DISC_FOOT_BOUND * of->normal * of->stride * (of->reach + r);
    bool in_range = filter_has_scale(flat_scale_bits(of) | filter_scale_bits(r, slack, slack));
    return (disc_foot_terms){fx * fx + fy * fy + fz * fz, r * fabs(of->e), slack, in_range};
}

static inline flat_decision disc_decide(const sure_ray *ray, const sure_disc *disc)
{
    flat_terms of = flat_terms_of(ray, &disc->centre, &disc->normal);
    disc_foot_terms foot = disc_foot_terms_of(&of, ray, disc->radius);
    return flat_decide(&of, foot.in_range, disc_inside(&foot), disc_outside(&foot), ray);
}

#ifndef LANES /* From here on of one ray alone, with branches. */

/* FILTER_MISS as of plane_filter. Where the crossing is outside e may be 0: f is then 0 in the
 * disc's plane only. */
static INLINED filter_verdict disc_filter(const sure_ray *ray, const void *shape,
                                          filter_interval *found)
{
    const sure_disc *disc = (const sure_disc *)shape;
    flat_terms of = flat_terms_of(ray, &disc->centre, &disc->normal);
    disc_foot_terms foot = disc_foot_terms_of(&of, ray, disc->radius);
    bool inside = disc_inside(&foot);
    if (disc_outside(&foot) | flat_behind(&of, ray->t_min))
        return filter_miss_if(foot.in_range, ray);
    return inside && foot.in_range ? flat_crossing(&of, disc->radius, found) : FILTER_UNCERTAIN;
}

static inline polish_step disc_step(const sure_ray *ray, const void *shape, tagged_end end,
                                    double t)
{
    const sure_disc *disc = (const sure_disc *)shape;
    (void)end;
    return crossing_step(ray, &disc->centre, &disc->normal, t);
}

#endif
