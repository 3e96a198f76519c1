/* SPDX-License-Identifier: MIT */
/* What cylinder and cone share in the stages after the first. */
#pragma once

#include "../../stages/last/line.h"
#include "../../stages/stages.h"
#include "../planar/planar_exact.h"
#include "axial_filter.h"

/* The ends as double-doubles; their heads are the line's. */
typedef struct {
    dd less, more, base, top;
} capped_ends;

/* Keeps quotients by A.d finite, and is of no account for double-doubles either. */
#define CAPPED_TILT 0x1p-300

/* A.d, or what stands for one that is next to nothing. */
static inline dd capped_tilted(dd e)
{
    return fabs(e.head) < CAPPED_TILT ? (dd){CAPPED_TILT, 0} : e;
}

static inline double capped_gap(dd x, dd y)
{
    return (x.head - y.head) + (x.tail - y.tail);
}

/* The root of a number that is known to be 0 where it seems so. */
static inline dd capped_root(dd x)
{
    return x.head > 0 ? dd_sqrt(NULL, x) : (dd){0, 0};
}

/* As the filter decides, on ends that are known to more digits. */
static inline filter_verdict capped_decide(const capped_ends *at, axial_line *line, double d_d,
                                           double size, const sure_ray *ray, filter_interval *found)
{
    bool rising = capped_gap(at->top, at->base) > 0;
    dd low = rising ? at->base : at->top, high = rising ? at->top : at->base;
    axial_gaps gaps = {capped_gap(low, at->less), capped_gap(at->more, high),
                       filter_lesser(capped_gap(high, at->less), capped_gap(at->more, low)),
                       capped_gap(high, low)};
    line->less = at->less.head;
    line->more = at->more.head;
    line->base = at->base.head;
    line->top = at->top.head;
    filter_verdict verdict = axial_decide(line, gaps, d_d, size, ray, found);
    if (verdict == FILTER_INTERVAL) {
        found->enter.error += 0x1p-52 * fabs(found->enter.t);
        found->leave.error += 0x1p-52 * fabs(found->leave.t);
    }
    return verdict;
}

/* Is a line in one of the planes across an axis at its ends (axial_plane.c)? */
typedef enum { AXIAL_PLANE_UNKNOWN, AXIAL_PLANE_FROM, AXIAL_PLANE_TO } axial_plane;

/* Certain, or unknown; mostly the latter at once. `of`: what the filter has of the line, seen from
 * the axis's first end. */
axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to,
                           const axial_terms *of);

/* Does the ray start, at t_min = 0, in the plane of one of the chord's ends? That end is then put
 * at 0. of_from, of_to: which ends are in the planes through `from` and `to`. */
bool axial_starts(const sure_ray *ray, sure_vec3 from, sure_vec3 to, const axial_terms *of,
                  end_kind of_from, end_kind of_to, filter_interval *found);

/* The chord is boundary: a ray that starts between its ends is there already. */
static inline filter_verdict axial_plane_chord(filter_verdict verdict, sure_part part,
                                               const sure_ray *ray, bool both_ends,
                                               filter_interval *found)
{
    const filter_end start = {.end = {END_START, part}};
    if (verdict != FILTER_INTERVAL)
        return verdict;
    found->enter.end.part = found->leave.end.part = part;
    if (both_ends || found->enter.t - ray->t_min > found->enter.error ||
        ray->t_min - found->leave.t > found->leave.error)
        return FILTER_INTERVAL;
    if (!(bits_of(ray->t_min) == 0 && -found->enter.t > found->enter.error &&
          found->leave.t > found->leave.error))
        return FILTER_UNCERTAIN;
    *found = (filter_interval){start, start};
    return FILTER_INTERVAL;
}

/* What a row gives to the last stage (stages/shape.h), and the points of the endless wall: where
 * there are two, the first and the last, between which a steep line is outside a double cone. */
#define CAPPED_EXACT(shape)                                                                        \
    tagged_interval shape##_wall_exact(exact_context *c, const sure_ray *ray, const void *solid,   \
                                       line_coefficients *l);                                      \
    tagged_interval shape##_exact_interval(exact_context *c, const sure_ray *ray,                  \
                                           const void *solid, line_coefficients *l);               \
    sure_vec3 shape##_round_normal(exact_context *c, const sure_ray *ray, const void *solid,       \
                                   const line_coefficients *l, tagged_end at);
CAPPED_EXACT(cone)
CAPPED_EXACT(cylinder)

/* sure_<shape>_hit_certain: a branch where the line passes the wall's body, which spares the ends;
 * none behind it. */
#define CAPPED_HIT(shape)                                                                          \
    sure_status sure_##shape##_hit_certain(const sure_ray *ray, const sure_##shape *s,             \
                                           sure_hit *hit)                                          \
    {                                                                                              \
        const axial_terms terms = shape##_terms_of(ray, s);                                        \
        double discriminant = axial_discriminant(&terms);                                          \
        decided said = {.certain = false};                                                         \
        if (axial_is_certain(&terms, discriminant) & axial_fits(&terms, s->radius)) {              \
            if (discriminant < 0) {                                                                \
                if (filter_range(ray))                                                             \
                    return SURE_MISS;                                                              \
            } else {                                                                               \
                const shape##_ends ends = shape##_ends_of(&terms, discriminant, terms.inner);      \
                said = axial_answer(&ends.line, terms.d_d, terms.size, ray);                       \
            }                                                                                      \
        }                                                                                          \
        return said.certain ? decision_tell(&said, hit)                                            \
                            : stages_certain_hit(ray, s, hit, &shape##_row);                       \
    }

/* A cap's plane is crossed inside, at or outside its rim: 1, 0, -1. m is seen from the cap's
 * centre, e = A.d, h = A.m. */
static inline int capped_within(exact_context *c, exact e, exact h, vector_exact m, vector_exact d,
                                exact r)
{
    return exact_sign(c, difference_exact(c, disc_rim_exact(c, e, h, m, d, r)));
}

/* What the normal is made of, seen from the axis's first end. */
typedef struct {
    vector_exact m, d, axis;
    exact radius, height; /* height = axis.axis */
} capped_point;

static inline capped_point capped_point_of(exact_context *c, const sure_ray *ray, sure_vec3 from,
                                           sure_vec3 to, double radius)
{
    vector_exact axis = vector_between_exact(c, from, to);
    return (capped_point){vector_between_exact(c, from, ray->origin),
                          vector_of_exact(c, ray->direction), axis, exact_of(c, radius),
                          vector_square_exact(c, axis)};
}
