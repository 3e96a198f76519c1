/* SPDX-License-Identifier: MIT */
/* Rays and shapes in single precision, decided as exactly as in double: a float is the number that
 * it says, and so is every answer the one about these numbers. */
#pragma once

#include <surehit/many.h>

SURE_C_BEGIN

/* As the double forms, field by field: o, d, t_min, t_max; ... */
typedef struct {
    sure_float_vec3 origin, direction;
    float t_min, t_max;
} sure_ray_f;

typedef struct {
    sure_float_vec3 point, normal;
} sure_plane_f;

typedef struct {
    sure_float_vec3 centre, normal;
    float radius;
} sure_disc_f;

typedef struct {
    sure_float_vec3 centre;
    float radius;
} sure_sphere_f;

typedef struct {
    sure_float_vec3 base, top;
    float radius;
} sure_cylinder_f;

typedef struct {
    sure_float_vec3 base, apex;
    float radius;
} sure_cone_f;

typedef struct {
    sure_float_vec3 low, high;
} sure_box_f;

typedef struct {
    float t; /* the float next to t*, in multiples of the ray's direction */
    sure_part part;
    int leaves; /* 1 where the ray comes from a solid's inside and leaves it here, else 0 */
} sure_hit_f;

/* sure_<shape>_check_f: sure_<shape>_check of what the floats say.
 *
 * sure_<shape>_hit_certain_f, sure_<shape>_hit_exact_f: the first boundary point of the object on
 * the ray. Both give the same answer and take the same time: t is found in doubles, and nearly
 * always that is enough to know which float it rounds to.
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    the status, the part and the end of the chord are right, always; t is the float nearest
 *          to t*, ties to even, so within half an ulp; beyond the greatest float +infinity, and a
 *          zero is +0. In any rounding mode, subnormals flushed or not.
 *
 * sure_<shape>_normal_certain_f, sure_<shape>_normal_exact_f: the outward unit normal at a hit,
 * which is found anew. Entry: ray and object as given to sure_<shape>_hit_certain_f or _exact_f,
 * which answered SURE_HIT and *hit.
 *
 * Bound    certain_f: each component is off by at most SURE_FLOAT_NORMAL_ERROR. exact_f: each is
 *          the float next to it, ties to even, a zero +0.
 *
 * sure_<shape>_hits_certain_f: the same for many rays in one call, as sure_objects_hits_certain_f.
 *
 * Source   the shape's header.
 * Proof    the shape's header, docs/proofs/floats.md.
 *
 * Law 1: the status, the part and `leaves` are those of tier exact of the same numbers as doubles.
 *        Where exact's t, or a component of its normal, is no tie of floats, rounding it to a float
 *        makes t, and exact_f's normal.
 * Law 2: every environment answers the same bits. */
#define SURE_FLOAT_TIER(shape, tier)                                                               \
    sure_status sure_##shape##_hit_##tier##_f(const sure_ray_f *ray, const sure_##shape##_f *s,    \
                                              sure_hit_f *hit);                                    \
    sure_float_vec3 sure_##shape##_normal_##tier##_f(                                              \
        const sure_ray_f *ray, const sure_##shape##_f *s, const sure_hit_f *hit);
#define SURE_FLOAT_FUNCTIONS(shape, SHAPE)                                                         \
    sure_field sure_##shape##_check_f(const sure_ray_f *ray, const sure_##shape##_f *s);           \
    SURE_FLOAT_TIER(shape, certain)                                                                \
    SURE_FLOAT_TIER(shape, exact)                                                                  \
    void sure_##shape##_hits_certain_f(size_t count, const sure_rays *rays,                        \
                                       const sure_##shape##_f *s, const sure_hits *hits);
SURE_EACH_SHAPE(SURE_FLOAT_FUNCTIONS)

/* sure_rays_of and sure_objects_of of structs of floats. */
sure_rays sure_rays_of_f(const void *first, ptrdiff_t stride);
sure_objects sure_objects_of_f(sure_shape shape, const void *first, ptrdiff_t stride);

/* Ray i meets object i? All columns of numbers, of rays, objects and answers, are of floats.
 *
 * Entry    as sure_objects_hits; hits->t_error is not wanted: half an ulp of t is what it would be.
 * Returns  in the columns what sure_<shape>_hit_certain_f and sure_<shape>_normal_certain_f answer
 *          for each ray and its object; on miss and invalid the status alone.
 * Bound    theirs.
 * Source   the shape's header.
 * Proof    the shape's header, docs/proofs/floats.md.
 *
 * Law 1: every answer is the call's for that ray alone, bit by bit. */
void sure_objects_hits_certain_f(size_t count, const sure_rays *rays, const sure_objects *objects,
                                 const sure_hits *hits);

/* sure_objects_occluded of floats: by what sure_objects_hits_certain_f answers. */
size_t sure_objects_occluded_certain_f(size_t count, const sure_rays *rays,
                                       const sure_objects *objects, uint8_t *mask);

SURE_C_END
