/* SPDX-License-Identifier: MIT */
/* The shapes, and what each is made of: data for those who handle any of them. */
#pragma once

#include <surehit/answer.h>
#include <surehit/ray.h>

SURE_C_BEGIN

/* What holds for the functions of every shape, sure_<shape>_hit_<tier> and the others. They are
 * tested by these numbers.
 *
 * Law 1: scaling origin, object and t range by 2^k (d kept) leaves status, part and normal and
 *        turns t into t * 2^k; in the plain tiers while nothing over- or underflows, in exact
 *        always (t* 2^k rounded), in certain always, t and normal within their errors.
 * Law 2: d -> 2^k d with the t range times 2^-k leaves status, part and normal and turns t into
 *        t * 2^-k, likewise.
 * Law 3: negating one coordinate of everything, or exchanging x and y, leaves status, part and t
 *        and does the same to the normal, in certain t and normal within their errors. A box's
 *        faces then have each other's names, and on an edge another one may come first.
 * Law 4: occluded's status is hit's; a hit's t is an end of the interval, or t_min, on a chord that
 *        lies in the boundary (in certain within the errors, in the plain tiers as their precision
 *        has it). `leaves` is 1 where it is the second end and the first lies before t_min.
 * Law 5: on miss and invalid no output is touched; invalid exactly when check names a field.
 * Law 6: widening [t_min, t_max] never turns a hit into a miss; in certain and exact it does not
 *        put it off either: exact's t is no greater, certain's by no more than both errors. There
 *        a range that is cut at the double above t + t_error keeps the hit.
 * Law 7: t lies in [t_min, t_max], in float32 as floats have them; the normal is a unit vector up
 *        to rounding, never a NaN, and not zero. Of plain tiers, where subnormals are flushed, it
 *        may be zero, and t 0 where t_min is flushed.
 * Law 8: certain and exact agree in status, part and leaves; |t_certain - t_exact| <= t_error and
 *        half an ulp; their normals differ by no more than SURE_NORMAL_ERROR and a rounding.
 * Law 9: where sure_object_stage tells SURE_STAGE_DOUBLE for certain, stable's answer is certain's.
 *        Elsewhere stable's hit is right and |t - t*| <= t_error if that is finite. Laws 1 and 2
 *        bind it where it is certain of both rays or guesses at both. */

/* sure_<shape>_check: the first invalid field of ray or object, in the contract's order, or
 * SURE_FIELD_NONE.
 *
 * sure_<shape>_hit_<tier>: the first boundary point of the object on the ray.
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit; SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: status and t as their precision has them, t_error = +infinity.
 *          stable: where the first stage of certain is certain its answer, else a guess with
 *          t_error = +infinity. certain, exact: the status, the part and the end of the chord are
 *          right, always; certain: |t - t*| <= t_error, and t_error |d| keeps to SURE_T_ERROR_CAP
 *          where a double can; exact: t correctly rounded, in any rounding mode, t_error half an
 *          ulp, or 0 where t_min is between the ends of a chord that lies in the surface.
 *
 * sure_<shape>_interval_<tier>: both ends of the chord, for what lies beyond the first hit.
 * SURE_HIT when the closed chord and [t_min, t_max] have a point in common (the ray may then lie
 * wholly inside, where sure_<shape>_hit_<tier> says miss); otherwise as above. certain's ends are
 * off by no more than SURE_T_ERROR_CAP allows, exact's are correctly rounded.
 *
 * sure_<shape>_occluded_<tier>: is there a hit at all? Its status, without its outputs.
 *
 * sure_<shape>_normal_<tier>: the outward unit normal at a hit. Entry: ray and object as given to
 * sure_<shape>_hit_<tier>, which answered SURE_HIT and *hit. Bound: certain SURE_NORMAL_ERROR a
 * component; exact correctly rounded; the plain tiers none.
 *
 * Source   the shape's header.
 * Proof    the shape's header. */
#define SURE_SHAPE_FUNCTIONS(shape)                                                                \
    sure_field sure_##shape##_check(const sure_ray *ray, const sure_##shape *shape);               \
    SURE_SHAPE_TIER(shape, float32)                                                                \
    SURE_SHAPE_TIER(shape, textbook)                                                               \
    SURE_SHAPE_TIER(shape, stable)                                                                 \
    SURE_SHAPE_TIER(shape, certain)                                                                \
    SURE_SHAPE_TIER(shape, exact)

#define SURE_SHAPE_TIER(shape, tier)                                                               \
    sure_status sure_##shape##_hit_##tier(const sure_ray *ray, const sure_##shape *shape,          \
                                          sure_hit *hit);                                          \
    sure_status sure_##shape##_interval_##tier(const sure_ray *ray, const sure_##shape *shape,     \
                                               sure_interval *interval);                           \
    sure_status sure_##shape##_occluded_##tier(const sure_ray *ray, const sure_##shape *shape);    \
    sure_vec3 sure_##shape##_normal_##tier(const sure_ray *ray, const sure_##shape *shape,         \
                                           const sure_hit *hit);

/* Every shape once, for tables: DO(plane, PLANE) ... */
#define SURE_EACH_SHAPE(DO)                                                                        \
    DO(plane, PLANE)                                                                               \
    DO(disc, DISC) DO(sphere, SPHERE) DO(cylinder, CYLINDER) DO(cone, CONE) DO(box, BOX)

/* SURE_SHAPE_PLANE, ... */
#define SURE_SHAPE_OF(shape, SHAPE) SURE_SHAPE_##SHAPE,
typedef enum { SURE_EACH_SHAPE(SURE_SHAPE_OF) } sure_shape;

#define SURE_SHAPES 6

/* What a field holds. */
typedef enum {
    SURE_KIND_POINT,       /* finite */
    SURE_KIND_OTHER_POINT, /* finite, and not the first field's point */
    SURE_KIND_HIGH,        /* finite, no coordinate below that of the first field's point */
    SURE_KIND_NORMAL,      /* finite, not zero */
    SURE_KIND_RADIUS       /* one number: finite, not negative */
} sure_kind;

typedef struct {
    sure_field name;
    sure_kind kind;
    int at; /* so many doubles of the shape's struct stand before it */
} sure_shape_field;

#define SURE_SHAPE_FIELDS 3
#define SURE_SHAPE_PARTS 6
#define SURE_SHAPE_NUMBERS 7

/* A shape as data. Its struct is `numbers` doubles, those of its fields, in the contract's
 * order. */
typedef struct {
    const char *name;
    int solid;   /* has an inside */
    int bounded; /* lies in a box */
    int numbers, field_count, part_count;
    sure_shape_field fields[SURE_SHAPE_FIELDS];
    sure_part parts[SURE_SHAPE_PARTS];
} sure_shape_info;

/* Entry: shape is a member. */
const sure_shape_info *sure_shape_info_of(sure_shape shape);

/* "plane", "disc", ...: the shapes of the case format; NULL for a number that is no shape. */
const char *sure_shape_name(sure_shape shape);

/* Finds the shape of that name: 1 and *shape written, or 0 and *shape untouched. */
int sure_shape_from_name(const char *name, sure_shape *shape);

SURE_C_END
