/* SPDX-License-Identifier: MIT */
#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../span.h"

#include <surehit/sphere.h>

/* |o + t d - C|^2 = r^2 with rc = C - o:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 = 0
 *     D/4 = (rc.d)^2 - d.d (rc.rc - r^2)
 *     t   = (rc.d -+ sqrt(D/4)) / d.d
 */
static inline quadratic sphere_quadratic(const real_ray *ray, const real *of)
{
    vec3 rc = vec3_sub(SPAN_VECTOR(of, sphere, centre), ray->origin), d = ray->direction;
    real r = SPAN_NUMBER(of, sphere, radius);
    return (quadratic){vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r};
}

static inline span sphere_span(const real_ray *ray, const real *of)
{
    quadratic q = sphere_quadratic(ray, of);
    real roots[2];
    if (!quadratic_roots(q.a, q.half_b, q.c, roots))
        return span_empty();
    return span_of(roots[0], roots[1], SURE_PART_SURFACE);
}

static inline bool sphere_plain(const real_ray *ray, const real *of, span_first *first)
{
    quadratic q = sphere_quadratic(ray, of);
    real quarter = quadratic_quarter(&q), ends[2];
    if (!(q.a > 0 && round_surely_valid(ray, quarter, SPAN_NUMBER(of, sphere, radius))))
        return false;
    quadratic_ends(&q, quarter, ends);
    *first = (span_first){.met = quarter >= 0,
                          .t = span_first_end(ends[0], ends[1], ray),
                          .part = SURE_PART_SURFACE,
                          .leaves = ends[0] < ray->t_min};
    return true;
}

SPAN_QUESTIONS(sphere)

sure_vec3 TIER(sure_sphere_normal)(const sure_ray *ray, const sure_sphere *sphere,
                                   const sure_hit *hit)
{
    vec3 outward = span_point(ray, hit->t, sphere->centre);
    return span_normal(outward, sphere->radius > 0, ray);
}
