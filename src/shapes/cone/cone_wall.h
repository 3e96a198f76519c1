/* The cone_wall stem's formula, for the stems that have such a wall. */
#ifndef SHAPES_CONE_WALL_H
#define SHAPES_CONE_WALL_H

#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../sight.h"
#include "../span.h"

#include <surehit/cone.h>

#ifndef SURE_STABLE
/* Ray and cone by the products that wall and height share: N = apex - base of any length, rq = apex
 * - o. A point is N.(rq - t d) of N.N below the apex. */
typedef struct {
    vec3 d, rq;
    real n_n, n_d, n_rq, r;
} cone_line;

static inline cone_line cone_line_from(const sure_ray *ray, const sure_cone *cone)
{
    vec3 apex = vec3_from(cone->apex);
    vec3 n = vec3_sub(apex, vec3_from(cone->base));
    vec3 rq = vec3_sub(apex, vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    return (cone_line){.d = d,
                       .rq = rq,
                       .n_n = vec3_dot(n, n),
                       .n_d = vec3_dot(n, d),
                       .n_rq = vec3_dot(n, rq),
                       .r = (real)cone->radius};
}

/* ((Q - P).N)^2 = |Q - P|^2 N.N cos^2(theta), cos^2(theta) = h^2 / (h^2 + r^2), h^2 = N.N: the
 * notes' equation for an axis of any length, divided by -h^2 cos^2(theta) so that it is negative
 * inside:
 *
 *     a   = d.d   - k (d.N)^2            k = (h^2 + r^2) / h^4
 *     b/2 = -(rq.d - k (rq.N)(d.N))
 *     c   = rq.rq - k (rq.N)^2
 */
typedef quadratic cone_quadratic;

static inline cone_quadratic cone_wall_quadratic(const cone_line *line)
{
    real slant_square = line->n_n + line->r * line->r;
    real d_share = line->n_d / line->n_n;
    real rq_share = line->n_rq / line->n_n;
    return (cone_quadratic){
        vec3_dot(line->d, line->d) - slant_square * d_share * d_share,
        -(vec3_dot(line->rq, line->d) - slant_square * rq_share * d_share),
        vec3_dot(line->rq, line->rq) - slant_square * rq_share * rq_share,
    };
}

static inline int cone_wall_roots(const cone_quadratic *q, real roots[2])
{
    return quadratic_roots(q->a, q->half_b, q->c, roots);
}
#else
/* Stable: |P - Q| is split into its parts along and across N, which have no cancellation between
 * them. With m = o - Q, e = d x N, f = m x N, w = d x m:
 *
 *     a   = N.N e.e - r^2 (N.d)^2
 *     b/2 = N.N e.f - r^2 (N.d)(N.m)
 *     c   = N.N f.f - r^2 (N.m)^2
 *     D/4 = (N.N)^2 (r^2 |w x N|^2 - N.N (N.w)^2)
 */
typedef struct {
    sight s;
    real n_d;
} cone_line;

typedef struct {
    real a, half_b, c;
    const sight *s;
} cone_quadratic;

/* p x - q y */
static inline twice cone_form(twice p, twice x, twice q, twice y)
{
    return twice_difference(twice_product(p, x), twice_product(q, y));
}

static inline sight_verdict cone_look(const sight_parts *p, sight *s)
{
    vec3 e = vec3_cross(p->d, p->n), f = vec3_cross(p->m_to, p->n), w = vec3_cross(p->d, p->m_to);
    vec3 w_n = vec3_cross(w, p->n);
    real d_d = vec3_dot(p->d, p->d), m_m = vec3_dot(p->m_to, p->m_to), n_n = vec3_dot(p->n, p->n);
    real n_d = vec3_dot(p->n, p->d), n_m = vec3_dot(p->n, p->m_to), n_w = vec3_dot(p->n, w);
    real rr = p->r * p->r, wide = rr * vec3_dot(w_n, w_n);
    real across_d = n_n * vec3_dot(e, e), across_m = n_n * vec3_dot(f, f);
    *s = (sight){.a = across_d - rr * n_d * n_d,
                 .half_b = n_n * vec3_dot(e, f) - rr * n_d * n_m,
                 .c = across_m - rr * n_m * n_m,
                 .quarter = wide - n_n * n_w * n_w,
                 .factor = n_n,
                 .speed = n_d,
                 .over = vec3_dot(p->n, p->m),
                 .over_to = n_m};
    real lengths = m_m + vec3_dot(p->m, p->m);
    if (!(scale_is_moderate(d_d) & scale_is_moderate(n_n) & scale_is_moderate(lengths)) |
        (rr > 0x1p200))
        return SIGHT_WILD;
    if ((rr < SIGHT_SLIM * n_n) | (n_n < SIGHT_LOST * rr) | (m_m < SIGHT_LOST * lengths) |
        (vec3_dot(w, w) < SIGHT_SMALL * d_d * m_m) | sight_cancels(s->a, across_d))
        return SIGHT_HARD;
    if (s->quarter < -wide) /* missed for certain */
        return SIGHT_CLEAR;
    if (sight_cancels(s->c, across_m) | sight_cancels(s->quarter, wide))
        return SIGHT_HARD;
    return sight_heights_cancel(p, s) ? SIGHT_LEVEL : SIGHT_CLEAR;
}

static inline void cone_look_hard(const twice_sight *p, sight *s)
{
    twice_vec3 e = twice_cross(&p->d, &p->n), f = twice_cross(&p->m_to, &p->n);
    twice_vec3 w = twice_cross(&p->d, &p->m_to), w_n = twice_cross(&w, &p->n);
    twice n_d = twice_dot(&p->n, &p->d), n_m = twice_dot(&p->n, &p->m_to);
    twice n_n = twice_dot(&p->n, &p->n), n_w = twice_dot(&p->n, &w), rr = twice_product(p->r, p->r);
    twice a = cone_form(n_n, twice_dot(&e, &e), rr, twice_product(n_d, n_d));
    twice half_b = cone_form(n_n, twice_dot(&e, &f), rr, twice_product(n_d, n_m));
    twice c = cone_form(n_n, twice_dot(&f, &f), rr, twice_product(n_m, n_m));
    twice quarter = cone_form(rr, twice_dot(&w_n, &w_n), n_n, twice_product(n_w, n_w));
    sight_heights(p, s);
    s->a = twice_rounded(a);
    s->half_b = twice_rounded(half_b);
    s->c = twice_rounded(c);
    s->quarter = twice_rounded(quarter);
    s->factor = n_n.head;
    s->past_end = vec3_is_zero(twice_head(&w));
    if (s->past_end && s->a == 0) /* a generator: these are zero but for rounding */
        s->half_b = s->c = 0;
}

SIGHT_OF(cone)

static inline cone_line cone_line_from(const sure_ray *ray, const sure_cone *cone)
{
    const sight_of object = {&cone->base, &cone->apex, NULL, cone->radius, true};
    sight s = cone_sight(ray, &object);
    return (cone_line){s, s.speed};
}

static inline cone_quadratic cone_wall_quadratic(const cone_line *line)
{
    return (cone_quadratic){line->s.a, line->s.half_b, line->s.c, &line->s};
}

/* A line through the apex has its roots there. */
static inline int cone_wall_roots(const cone_quadratic *q, real roots[2])
{
    const sight *s = q->s;
    if (s->quarter < 0)
        return 0;
    if (s->past_end)
        roots[0] = roots[1] = s->speed == 0 ? -s->half_b / s->a : -s->over_to / s->speed;
    else
        sight_roots(s, roots);
    return 1;
}
#endif

static inline span cone_line_span(span found, const cone_line *line)
{
#ifdef SURE_STABLE
    return sight_span(found, &line->s);
#else
    (void)line;
    return found;
#endif
}

#endif
