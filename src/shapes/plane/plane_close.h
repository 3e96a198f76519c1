/* The second stage of the plane: a better N.d and N.m settle nearly all that the filter leaves.
 * docs/proofs/flat_close.md proves it. */
#ifndef SHAPES_PLANE_CLOSE_H
#define SHAPES_PLANE_CLOSE_H

#include "../planar/flat_close.h"

static inline filter_verdict plane_crossing_closely(const sure_ray *ray, const sure_plane *plane,
                                                    const flat_line *l, t_wanted wanted,
                                                    sure_hit *hit)
{
    filter_interval found;
    filter_end first;
    (void)flat_found(l->t, l->error, &found);
    filter_verdict verdict = filter_first(&found, ray, &first);
    if (verdict == FILTER_MISS)
        return verdict;
    *hit = (sure_hit){l->t, l->error, SURE_PART_SURFACE, 0};
    if (verdict == FILTER_INTERVAL && wanted == T_CERTAIN)
        return flat_line_keeps_limit(l, l->error, 0) ? FILTER_INTERVAL : FILTER_UNCERTAIN;
    polish_point p = polish_point_of(ray, &plane->point, l->t);
    if (verdict == FILTER_UNCERTAIN)
        return flat_crosses_at(ray, &plane->point, &plane->normal, l->t, &p)
                   ? flat_exactly(ray, l->t, wanted, hit)
                   : FILTER_UNCERTAIN;
    bool rounded = polish_round(l->t, flat_step(l, &p, &plane->normal), &hit->t);
    hit->t_error = half_ulp(hit->t);
    return rounded ? FILTER_INTERVAL : FILTER_UNCERTAIN;
}

/* Entry: any input, round to nearest. */
static inline filter_verdict plane_close(const sure_ray *ray, const sure_plane *plane,
                                         t_wanted wanted, sure_hit *hit)
{
    flat_line l = flat_line_of(ray, &plane->point, &plane->normal);
    switch (l.place) {
    case FLAT_UNCERTAIN: break;
    case FLAT_BESIDE: return filter_miss_if(true, ray);
    case FLAT_WITHIN: return flat_start(ray, hit);
    case FLAT_CROSSES: return plane_crossing_closely(ray, plane, &l, wanted, hit);
    }
    return FILTER_UNCERTAIN;
}

#endif
