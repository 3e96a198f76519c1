#include "../../geometry/quadratic.h"
#include "../check.h"
#include "../plane/plane.h"
#ifdef SURE_STABLE
#include "../ball.h"
#endif

#include <surehit/disc.h>

/* The plane of the disc, then the distance from its centre Q, rc = Q - o:
 *
 *     t = N.rc / N.d,  |t d - rc|^2 <= r^2
 *
 * A line in the plane cuts the chord |t d - rc|^2 <= r^2 from the disc:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 <= 0
 */
#ifndef SURE_STABLE
static inline bool disc_holds(const plane_line *line, real t, real r)
{
    vec3 from_centre = vec3_sub(vec3_scale(t, line->d), line->rc);
    return vec3_dot(from_centre, from_centre) <= r * r;
}

static span disc_span(const sure_ray *ray, const sure_disc *disc)
{
    plane_line line = plane_line_from(ray, disc->centre, disc->normal);
    vec3 d = line.d, rc = line.rc;
    real r = (real)disc->radius;
    span found = plane_line_span(&line);
    if (found.boundary) {
        real roots[2];
        if (!quadratic_roots(vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r, roots))
            return span_empty();
        found.enter = roots[0];
        found.leave = roots[1];
        found.endless = false;
        return found;
    }
    return disc_holds(&line, found.enter, r) ? found : span_empty();
}

static inline bool disc_plain(const sure_ray *ray, const sure_disc *disc, span_first *first)
{
    plane_line line = plane_line_from(ray, disc->centre, disc->normal);
    if (!(flat_surely_valid(ray, line.n_rc, line.n_d) && radius_surely_valid(disc->radius)))
        return false;
    real t = plane_line_t(&line);
    *first = (span_first){disc_holds(&line, t, (real)disc->radius), t, SURE_PART_SURFACE};
    return true;
}
#else
/* Stable: where the line crosses the plane it is as far from the centre as P - Q is long,
 *
 *     (N.d) (P - Q) = (N.d) m - (N.m) d = N x (m x d)
 *
 * which is decided without dividing. */
static inline sight_verdict disc_look(const sight_parts *p, sight *s)
{
    vec3 way = vec3_cross(p->n, vec3_cross(p->m, p->d));
    real d_d = vec3_dot(p->d, p->d), n_n = vec3_dot(p->n, p->n), m_m = vec3_dot(p->m, p->m);
    real speed = vec3_dot(p->n, p->d), over = vec3_dot(p->n, p->m), rr = p->r * p->r;
    real reach = rr * speed * speed, far = vec3_dot(way, way);
    *s = (sight){.speed = speed, .over = over, .margin = reach - far};
    if (!(scale_is_moderate(d_d) & scale_is_moderate(n_n) & scale_is_moderate(m_m + rr)))
        return SIGHT_WILD;
    if (speed * speed < SIGHT_SMALL * d_d * n_n)
        return SIGHT_HARD;
    if (far > 2 * (reach + SIGHT_LOST * m_m * d_d * n_n)) /* missed for certain */
        return SIGHT_CLEAR;
    if (sight_cancels(s->margin, reach) | (rr < SIGHT_SMALL * m_m))
        return SIGHT_HARD;
    bool level = sight_dot_cancels(speed, p->n, p->d) | sight_dot_cancels(over, p->n, p->m);
    return level ? SIGHT_LEVEL : SIGHT_CLEAR;
}

/* Seen edge on, the disc is what its sphere leaves of the line. */
static inline void disc_look_hard(const twice_sight *p, sight *s)
{
    twice_vec3 turn = twice_cross(&p->m, &p->d), way = twice_cross(&p->n, &turn);
    twice speed = twice_dot(&p->n, &p->d), reach = twice_product(p->r, speed);
    twice margin = twice_difference(twice_product(reach, reach), twice_dot(&way, &way));
    s->margin = twice_rounded(margin);
    sight_heights(p, s);
    if (s->speed == 0)
        ball_look_hard(p, s);
}

SIGHT_OF(disc)

static span disc_span(const sure_ray *ray, const sure_disc *disc)
{
    const sight_of object = {&disc->centre, &disc->centre, &disc->normal, disc->radius, false};
    sight s = disc_sight(ray, &object);
    span line = plane_sight_span(&s);
    if (!line.boundary)
        return s.margin >= 0 ? sight_span(line, &s) : span_empty();
    if (s.quarter < 0)
        return span_empty();
    real roots[2];
    sight_roots(&s, roots);
    line.enter = roots[0];
    line.leave = roots[1];
    line.endless = false;
    return sight_span(line, &s);
}
#endif

SPAN_QUESTIONS(disc)

sure_vec3 TIER(sure_disc_normal)(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(disc->normal)));
}
