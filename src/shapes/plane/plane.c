#include "../check.h"
#include "plane.h"

#include <surehit/plane.h>

/* The derivation stands in plane.h: t = N.rc / N.d. */
#ifndef SURE_STABLE
static span plane_span(const sure_ray *ray, const sure_plane *plane)
{
    plane_line line = plane_line_from(ray, plane->point, plane->normal);
    return plane_line_span(&line);
}

static inline bool plane_plain(const sure_ray *ray, const sure_plane *plane, span_first *first)
{
    plane_line line = plane_line_from(ray, plane->point, plane->normal);
    if (!flat_surely_valid(ray, line.n_rc, line.n_d))
        return false;
    *first = (span_first){true, plane_line_t(&line), SURE_PART_SURFACE};
    return true;
}
#else
static inline sight_verdict plane_look(const sight_parts *p, sight *s)
{
    *s = (sight){.speed = vec3_dot(p->n, p->d), .over = vec3_dot(p->n, p->m)};
    if (!(scale_is_moderate(vec3_dot(p->d, p->d)) & scale_is_moderate(vec3_dot(p->n, p->n)) &
          scale_is_moderate(vec3_dot(p->m, p->m))))
        return SIGHT_WILD;
    bool level = sight_dot_cancels(s->speed, p->n, p->d) | sight_dot_cancels(s->over, p->n, p->m);
    return level ? SIGHT_LEVEL : SIGHT_CLEAR;
}

static inline void plane_look_hard(const twice_sight *p, sight *s)
{
    sight_heights(p, s);
}

SIGHT_OF(plane)

static span plane_span(const sure_ray *ray, const sure_plane *plane)
{
    const sight_of object = {&plane->point, &plane->point, &plane->normal, 0, false};
    sight s = plane_sight(ray, &object);
    return sight_span(plane_sight_span(&s), &s);
}
#endif

SPAN_QUESTIONS(plane)

sure_vec3 TIER(sure_plane_normal)(const sure_ray *ray, const sure_plane *plane, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(plane->normal)));
}
