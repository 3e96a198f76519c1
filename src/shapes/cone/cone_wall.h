/* SPDX-License-Identifier: MIT */
/* The formulas of the stems cone_wall and cone_normal, for the stems that have such a wall. */
#pragma once

#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../span.h"

#include <surehit/cone.h>

/* Ray and cone by the products that wall and height share: N = apex - base of any length, rq = apex
 * - o. A point is N.(rq - t d) of N.N below the apex. */
typedef struct {
    vec3 d, rq;
    real n_n, n_d, n_rq, r;
} cone_line;

static inline cone_line cone_line_from(const real_ray *ray, const real *of)
{
    vec3 apex = SPAN_VECTOR(of, cone, apex), d = ray->direction;
    vec3 n = vec3_sub(apex, SPAN_VECTOR(of, cone, base));
    vec3 rq = vec3_sub(apex, ray->origin);
    return (cone_line){.d = d,
                       .rq = rq,
                       .n_n = vec3_dot(n, n),
                       .n_d = vec3_dot(n, d),
                       .n_rq = vec3_dot(n, rq),
                       .r = SPAN_NUMBER(of, cone, radius)};
}

/* ((Q - P).N)^2 = |Q - P|^2 N.N cos^2(theta), cos^2(theta) = h^2 / (h^2 + r^2), h^2 = N.N: the
 * notes' equation for an axis of any length, divided by -h^2 cos^2(theta) so that it is negative
 * inside:
 *
 *     a   = d.d   - k (d.N)^2            k = (h^2 + r^2) / h^4
 *     b/2 = -(rq.d - k (rq.N)(d.N))
 *     c   = rq.rq - k (rq.N)^2
 */
static inline quadratic cone_wall_quadratic(const cone_line *line)
{
    real slant_square = line->n_n + line->r * line->r;
    real d_share = line->n_d / line->n_n;
    real rq_share = line->n_rq / line->n_n;
    return (quadratic){
        vec3_dot(line->d, line->d) - slant_square * d_share * d_share,
        -(vec3_dot(line->rq, line->d) - slant_square * rq_share * d_share),
        vec3_dot(line->rq, line->rq) - slant_square * rq_share * rq_share,
    };
}

/* The normal at P meets the axis in S. The triangle Q P S has its right angle at P, so
 *
 *     |QS| = |PQ| / cos(theta) = |PQ| s / h      s^2 = h^2 + r^2, h^2 = N.N
 *     S    = Q - |QS| N/h
 *     N_hit ~ P - S = (P - Q) + |PQ| s / h^2 N
 *
 * with P seen from the apex Q and N from base to apex.
 */
static inline vec3 cone_wall_outward(vec3 from_apex, vec3 axis, real radius)
{
    real height_square = vec3_dot(axis, axis);
    real slant_square = height_square + radius * radius;
    real distance = REAL(sqrt)(vec3_dot(from_apex, from_apex) * slant_square);
    return vec3_add(from_apex, vec3_scale(distance / height_square, axis));
}
