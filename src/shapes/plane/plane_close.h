/* SPDX-License-Identifier: MIT */
/* The plane in double-doubles. */
#pragma once

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
    polish_point p = polish_point_of(ray, &plane->point, l->t);
    if (verdict == FILTER_UNCERTAIN)
        return flat_crosses_at(ray, &plane->point, &plane->normal, l->t, &p)
                   ? flat_exactly(ray, l->t, wanted, hit)
                   : FILTER_UNCERTAIN;
    polish_step way = flat_step(l, &p, &plane->normal);
    return flat_answer(l, 0, &way, wanted, hit);
}

/* A better N.d and N.m settle nearly all that the filter leaves (docs/proofs/flat_close.md). */
static inline filter_verdict plane_refine_hit(const sure_ray *ray, const void *shape,
                                              t_wanted wanted, sure_hit *hit)
{
    const sure_plane *plane = shape;
    flat_line l = flat_line_of(ray, &plane->point, &plane->normal);
    switch (l.place) {
    case FLAT_UNCERTAIN: break;
    case FLAT_BESIDE: return filter_miss_if(true, ray);
    case FLAT_WITHIN: return flat_start(ray, hit);
    case FLAT_CROSSES: return plane_crossing_closely(ray, plane, &l, wanted, hit);
    }
    return FILTER_UNCERTAIN;
}

#define PLANE_CLOSE .refine_hit = plane_refine_hit, .step = plane_step, .spawn = planar_spawn_quick
