/* The cylinder_wall stem's formula, for the stems that have such a wall. */
#ifndef SHAPES_CYLINDER_WALL_H
#define SHAPES_CYLINDER_WALL_H

#include "../../geometry/project.h"
#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../sight.h"
#include "../span.h"

#include <surehit/cylinder.h>

#ifndef SURE_STABLE
/* Ray and cylinder by the products that wall and height share: N = top - base of any length, rc =
 * base - o. A point is at height N.(t d - rc) of N.N. */
typedef struct {
    vec3 d, rc;
    real n_n, n_d, n_rc, r;
} cylinder_line;

static inline cylinder_line cylinder_line_from(const sure_ray *ray, const sure_cylinder *cylinder)
{
    vec3 base = vec3_from(cylinder->base);
    vec3 n = vec3_sub(vec3_from(cylinder->top), base);
    vec3 rc = vec3_sub(base, vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    return (cylinder_line){.d = d,
                           .rc = rc,
                           .n_n = vec3_dot(n, n),
                           .n_d = vec3_dot(n, d),
                           .n_rc = vec3_dot(n, rc),
                           .r = (real)cylinder->radius};
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
#else
/* Stable: seen along the axis, in the plane of e = d x N and f = m x N, the wall is the circle of
 * radius r |N| (m = o - base; the length of N does not matter):
 *
 *     a = e.e,  b/2 = e.f,  c = f.f - r^2 N.N
 *     D/4 = r^2 N.N e.e - |e x f|^2
 */
static inline sight_verdict cylinder_look(const sight_parts *p, sight *s)
{
    vec3 e = vec3_cross(p->d, p->n), f = vec3_cross(p->m, p->n);
    real d_d = vec3_dot(p->d, p->d), n_n = vec3_dot(p->n, p->n), m_m = vec3_dot(p->m, p->m);
    vec3 g = vec3_cross(e, f);
    real a = vec3_dot(e, e), f_f = vec3_dot(f, f), g_g = vec3_dot(g, g);
    real rr = p->r * p->r, wide = rr * n_n * a;
    *s = (sight){.a = a,
                 .half_b = vec3_dot(e, f),
                 .c = f_f - rr * n_n,
                 .quarter = wide - g_g,
                 .factor = 1,
                 .speed = vec3_dot(p->n, p->d),
                 .over = vec3_dot(p->n, p->m),
                 .over_to = vec3_dot(p->n, p->m_to)};
    real lengths = m_m + vec3_dot(p->m_to, p->m_to) + rr;
    if (!(scale_is_moderate(d_d) & scale_is_moderate(n_n) & scale_is_moderate(lengths)))
        return SIGHT_WILD;
    if (a < SIGHT_NARROW * d_d * n_n)
        return SIGHT_HARD;
    if (g_g > 2 * (rr + SIGHT_LOST * m_m) * n_n * a) /* missed for certain */
        return SIGHT_CLEAR;
    if ((rr < SIGHT_SMALL * m_m) | sight_cancels(s->quarter, wide) | sight_cancels(s->c, f_f))
        return SIGHT_HARD;
    return sight_heights_cancel(p, s) ? SIGHT_LEVEL : SIGHT_CLEAR;
}

static inline void cylinder_look_hard(const twice_sight *p, sight *s)
{
    twice_vec3 e = twice_cross(&p->d, &p->n), f = twice_cross(&p->m, &p->n);
    twice_vec3 g = twice_cross(&e, &f);
    twice a = twice_dot(&e, &e), n_n = twice_dot(&p->n, &p->n);
    twice wall = twice_product(twice_product(p->r, p->r), n_n);
    sight_heights(p, s);
    s->a = twice_rounded(a);
    s->half_b = twice_rounded(twice_dot(&e, &f));
    s->c = twice_rounded(twice_difference(twice_dot(&f, &f), wall));
    s->quarter = twice_rounded(twice_difference(twice_product(wall, a), twice_dot(&g, &g)));
    s->factor = 1;
}

SIGHT_OF(cylinder)

static inline sight cylinder_line_from(const sure_ray *ray, const sure_cylinder *cylinder)
{
    const sight_of object = {&cylinder->base, &cylinder->top, NULL, cylinder->radius, false};
    return cylinder_sight(ray, &object);
}

static inline span cylinder_wall_span(const sight *s)
{
    if (s->a == 0) /* c is 0 all along a radius of 0 */
        return s->c <= 0 ? span_line(SURE_PART_WALL, s->c == 0) : span_empty();
    if (s->quarter < 0)
        return span_empty();
    real roots[2];
    sight_roots(s, roots);
    return span_of(roots[0], roots[1], SURE_PART_WALL);
}

/* N x ((P - base) x N), the part of P - base across the axis, times N.N. */
static inline vec3 cylinder_wall_outward(vec3 from_base, vec3 axis)
{
    vec3 along = vec3_near_one(axis);
    return vec3_cross(along, vec3_cross(vec3_near_one(from_base), along));
}
#endif

#endif
