/* SPDX-License-Identifier: MIT */
#include "../check.h"
#include "plane.h"

#include <surehit/plane.h>

/* The derivation stands in plane.h: t = N.rc / N.d. */
static inline span plane_span(const real_ray *ray, const real *of)
{
    plane_line line = plane_line_from(ray, of);
    return plane_line_span(&line);
}

static inline bool plane_plain(const real_ray *ray, const real *of, span_first *first)
{
    plane_line line = plane_line_from(ray, of);
    if (!flat_surely_valid(ray, line.n_rc, line.n_d))
        return false;
    *first = (span_first){true, plane_line_t(&line), SURE_PART_SURFACE, false};
    return true;
}

SPAN_QUESTIONS(plane)

sure_vec3 TIER(sure_plane_normal)(const sure_ray *ray, const sure_plane *plane, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(plane->normal)));
}
