/* SPDX-License-Identifier: MIT */
/* The cylinder_wall stem's formula, for the stems that have such a wall. */
#pragma once

#include "../../geometry/project.h"
#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../span.h"

#include <surehit/cylinder.h>

/* Ray and cylinder by the products that wall and height share: N = top - base of any length, rc =
 * base - o. A point is at height N.(t d - rc) of N.N. */
typedef struct {
    vec3 d, rc;
    real n_n, n_d, n_rc, r;
} cylinder_line;

static inline cylinder_line cylinder_line_from(const real_ray *ray, const real *of)
{
    vec3 base = SPAN_VECTOR(of, cylinder, base), d = ray->direction;
    vec3 n = vec3_sub(SPAN_VECTOR(of, cylinder, top), base);
    vec3 rc = vec3_sub(base, ray->origin);
    return (cylinder_line){.d = d,
                           .rc = rc,
                           .n_n = vec3_dot(n, n),
                           .n_d = vec3_dot(n, d),
                           .n_rc = vec3_dot(n, rc),
                           .r = SPAN_NUMBER(of, cylinder, radius)};
}

/* |P - C|^2 = ((P - C).N)^2 / N.N + r^2, the notes' equation for an axis of any length:
 *
 *     a   = d.d - (d.N)^2 / N.N
 *     b/2 = -(rc.d - (d.N)(rc.N) / N.N)
 *     c   = rc.rc - (rc.N)^2 / N.N - r^2
 *
 * a = 0, a line parallel to the axis, lies within the body when c <= 0 and in the wall when c = 0.
 * */
static inline quadratic cylinder_wall_quadratic(const cylinder_line *line)
{
    real d_share = line->n_d / line->n_n;
    real rc_share = line->n_rc / line->n_n;
    real a = vec3_dot(line->d, line->d) - line->n_d * d_share;
    real half_b = -(vec3_dot(line->rc, line->d) - line->n_d * rc_share);
    real c = vec3_dot(line->rc, line->rc) - line->n_rc * rc_share - line->r * line->r;
    return (quadratic){a, half_b, c};
}

static inline span cylinder_wall_span(const cylinder_line *line)
{
    quadratic q = cylinder_wall_quadratic(line);
    if (!(q.a > 0))
        return q.c <= 0 ? span_line(SURE_PART_WALL, q.c == 0 || line->r == 0) : span_empty();
    real roots[2];
    if (!quadratic_roots(q.a, q.half_b, q.c, roots))
        return span_empty();
    return span_of(roots[0], roots[1], SURE_PART_WALL);
}

/* From the foot of the point on the axis to the point, both seen from the base. */
static inline vec3 cylinder_wall_outward(vec3 from_base, vec3 axis)
{
    return vec3_sub(from_base, project(from_base, axis));
}
