#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../sight.h"
#include "../span.h"
#ifdef SURE_STABLE
#include "../ball.h"
#endif

#include <surehit/sphere.h>

/* |o + t d - C|^2 = r^2 with rc = C - o:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 = 0
 *     D/4 = (rc.d)^2 - d.d (rc.rc - r^2)
 *     t   = (rc.d -+ sqrt(D/4)) / d.d
 */
#ifndef SURE_STABLE
static inline quadratic sphere_quadratic(const sure_ray *ray, const sure_sphere *sphere)
{
    vec3 rc = vec3_sub(vec3_from(sphere->centre), vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    real r = (real)sphere->radius;
    return (quadratic){vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r};
}

static span sphere_span(const sure_ray *ray, const sure_sphere *sphere)
{
    quadratic q = sphere_quadratic(ray, sphere);
    real roots[2];
    if (!quadratic_roots(q.a, q.half_b, q.c, roots))
        return span_empty();
    return span_of(roots[0], roots[1], SURE_PART_SURFACE);
}

static inline bool sphere_plain(const sure_ray *ray, const sure_sphere *sphere, span_first *first)
{
    quadratic q = sphere_quadratic(ray, sphere);
    real quarter = quadratic_quarter(&q), ends[2];
    if (!(q.a > 0 && round_surely_valid(ray, quarter, sphere->radius)))
        return false;
    quadratic_ends(&q, quarter, ends);
    *first = (span_first){
        .met = quarter >= 0, .t = span_first_end(ends[0], ends[1], ray), .part = SURE_PART_SURFACE};
    return true;
}
#else
/* Stable: ball.h derives D/4 without cancellation. */
static inline sight_verdict sphere_look(const sight_parts *p, sight *s)
{
    vec3 w = vec3_cross(p->d, p->m);
    real a = vec3_dot(p->d, p->d), m_m = vec3_dot(p->m, p->m), w_w = vec3_dot(w, w);
    real rr = p->r * p->r;
    *s = (sight){.a = a,
                 .half_b = vec3_dot(p->m, p->d),
                 .c = m_m - rr,
                 .quarter = rr * a - w_w,
                 .factor = 1};
    if (!(scale_is_moderate(a) & scale_is_moderate(m_m + rr)))
        return SIGHT_WILD;
    bool missed = w_w > 2 * (rr + SIGHT_LOST * m_m) * a;
    bool hard =
        sight_cancels(s->quarter, rr * a) | sight_cancels(s->c, m_m) | (rr < SIGHT_SMALL * m_m);
    return hard & !missed ? SIGHT_HARD : SIGHT_CLEAR;
}

static inline void sphere_look_hard(const twice_sight *p, sight *s)
{
    ball_look_hard(p, s);
}

SIGHT_OF(sphere)

static span sphere_span(const sure_ray *ray, const sure_sphere *sphere)
{
    const sure_vec3 any = {1, 0, 0};
    const sight_of object = {&sphere->centre, &sphere->centre, &any, sphere->radius, false};
    sight s = sphere_sight(ray, &object);
    if (s.quarter < 0)
        return span_empty();
    real roots[2];
    sight_roots(&s, roots);
    return sight_span(span_of(roots[0], roots[1], SURE_PART_SURFACE), &s);
}
#endif

SPAN_QUESTIONS(sphere)

sure_vec3 TIER(sure_sphere_normal)(const sure_ray *ray, const sure_sphere *sphere,
                                   const sure_hit *hit)
{
    vec3 outward = sight_point(ray, hit->t, sphere->centre);
    return span_normal(outward, sphere->radius > 0, ray);
}
