/* The first stage of the disc; docs/proofs/disc_filter.md proves it. The line crosses its plane at
 * t (plane_filter.h), at p = m + t d from its centre, m = o - C; is |p| < r? */
#ifndef INTERSECT_DISC_FILTER_H
#define INTERSECT_DISC_FILTER_H

#include "plane_filter.h"

#include <surehit/disc.h>

static inline filter_verdict disc_filter(const sure_ray *ray, const sure_disc *disc,
                                         filter_chord *found)
{
    crossing at = plane_crossing(ray, &disc->centre, &disc->normal);
    double px = at.mx + at.t * ray->direction.x;
    double py = at.my + at.t * ray->direction.y;
    double pz = at.mz + at.t * ray->direction.z;
    double square = px * px + py * py + pz * pz, r = disc->radius;
    double slack = 1.5 * at.error * at.stride + SURE_DISC_RADIUS_BOUND * (at.reach + r);
    double inner = r - slack, outer = r + slack;
    bool inside = inner > 0 && inner * inner > square;
    bool outside = square > outer * outer;
    if (!(at.certain && filter_scales(at.reach, at.stride, at.normal) && filter_scales(r, r, r)))
        return FILTER_UNCERTAIN;
    if (inside)
        return crossing_keeps_limit(&at, r) ? crossing_found(&at, found) : FILTER_UNCERTAIN;
    return filter_miss_if(outside, ray);
}

/* As plane_polish. */
static inline bool disc_polish(const sure_ray *ray, const sure_disc *disc, const filter_end *end,
                               double *t)
{
    return polish_round(end->t, crossing_step(ray, &disc->centre, &disc->normal, end->t), t);
}

#endif
