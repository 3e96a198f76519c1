/* SPDX-License-Identifier: MIT */
/* What cylinder and cone share in the stages after the first. */
#pragma once

#include "../planar/planar_stages.h"
#include "axial_filter.h"

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

/* A line in an end plane. */
static inline filter_verdict axial_plane_chord(filter_verdict verdict, sure_part part,
                                               const sure_ray *ray, bool both_ends,
                                               filter_interval *found)
{
    if (verdict != FILTER_INTERVAL)
        return verdict;
    found->enter.end.part = found->leave.end.part = part;
    return planar_chord(part, ray, both_ends, found);
}

/* Where a line that touches the wall (D = 0) does: beside the solid, between its planes or in one
 * of them, by the two heights of cylinder_touch and cone_touch. */
typedef struct {
    two_terms_f64 (*nearly)(const sure_ray *, const void *shape);
    two_terms_mod128 (*whole)(const sure_ray *, const void *shape);
    sure_part parts[2]; /* in the planes */
} capped_touching;

/* A height as doubles have it is off by at most this times size d.d, of a cone above its base times
 * 2 H of that (docs/proofs/axial_filter.md). */
#define CAPPED_TOUCH_SHARE 0x1p-47

/* found: the touch, if it is on the solid; its part. error: of each height as doubles have it.
 * FILTER_MISS: it is beside. */
filter_verdict capped_touch(const capped_touching *of, const sure_ray *ray, const void *shape,
                            const double error[2], filter_interval *found);

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
 * none behind it. What is uncertain here mostly is for the filter, too: it is not asked again. */
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
                            : stages_certain_rest(ray, s, hit, &shape##_row);                      \
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
