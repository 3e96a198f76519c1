/* SPDX-License-Identifier: MIT */
/* The plane stem's formula, for the stems that lie in a plane. */
#pragma once

#include "../span.h"

/* N.(o + t d - Q) = 0 with rc = Q - o:
 *
 *     t = N.rc / N.d           one point, or for N.d = 0
 *     the whole line when N.rc = 0, nothing otherwise
 */
typedef struct {
    vec3 d, rc;
    real n_d, n_rc;
} plane_line;

/* Of a plane or a disc: it begins like one. */
static inline plane_line plane_line_from(const real_ray *ray, const real *of)
{
    vec3 d = ray->direction, n = SPAN_VECTOR(of, plane, normal);
    vec3 rc = vec3_sub(SPAN_VECTOR(of, plane, point), ray->origin);
    return (plane_line){.d = d, .rc = rc, .n_d = vec3_dot(n, d), .n_rc = vec3_dot(n, rc)};
}

/* Entry: N.d is not 0. */
static inline real plane_line_t(const plane_line *line)
{
    return line->n_rc / line->n_d;
}

static inline span plane_line_span(const plane_line *line)
{
    if (line->n_d == 0)
        return line->n_rc == 0 ? span_line(SURE_PART_SURFACE, true) : span_empty();
    real t = plane_line_t(line);
    return span_of(t, t, SURE_PART_SURFACE);
}
