/* SPDX-License-Identifier: MIT */
/* The first stage of the box; docs/proofs/box.md proves it. The line is between the two planes
 * across axis i for t between
 *
 *     (low_i - o_i) / d_i   and   (high_i - o_i) / d_i
 *
 * and in the box where it is so for all three: from the last of the near planes to the first of the
 * far ones. Which of them that is is as good as random, so that is no branch. */
#pragma once

#include "../plane/plane_filter.h"
#ifndef LANES
#include "../../stages/decision.h"
#endif

#include <surehit/box.h>

/* A t is off by at most this of itself and, where numbers underflow, BOX_FLOOR: the plane's bound,
 * with |N| = 1 and no other coordinates. */
#define BOX_SHARE (0x1.1p1 * SURE_CROSSING_T_BOUND)
#define BOX_FLOOR 0x1p-766
/* What two that differ by less may underflow to. */
#define BOX_APART 0x1p-736
/* Coordinates are less than BOX_FAR, and no t of a plane that is crossed is near BOX_NEVER. */
#define BOX_FAR 0x1p256
#define BOX_NEVER 0x1p514

/* What comparisons tell, as bits where doubles are computed: is x < y, and is neither NaN? */
#ifdef LANES
typedef bool box_told;
#define BOX_LESS(x, y) ((x) < (y))
#define BOX_ORDERED(x, y) (((x) <= (y)) | ((x) > (y)))
#define BOX_TOLD(told) (told)
#elif defined(FILTER_PAIR)
typedef filter_bits box_told;
typedef double box_pair __attribute__((vector_size(16)));
#define BOX_COMPARED(how, x, y)                                                                    \
    ((box_told)__builtin_ia32_cmp##how##sd((box_pair)filter_bits_of(x),                            \
                                           (box_pair)filter_bits_of(y)))
#define BOX_LESS(x, y) BOX_COMPARED(lt, x, y)
#define BOX_ORDERED(x, y) BOX_COMPARED(ord, x, y)
#define BOX_TOLD(told) ((__builtin_ia32_movmskpd((box_pair)(told)) & 1) != 0)
#else
typedef uint64_t box_told;
#define BOX_LESS(x, y) filter_all((x) < (y))
#define BOX_ORDERED(x, y) filter_all(!isunordered(x, y))
#define BOX_TOLD(told) ((told) != 0)
#endif

/* t of the planes across an axis, and how far these are. Where d is 0 they are infinite: apart,
 * between the planes; or one, outside of them; and no numbers on a face. */
typedef struct {
    double near, far;
    double to_low, to_high;
    box_told crossed;
} box_slab;

static inline box_slab box_slab_of(double o, double d, double low, double high)
{
    double per_d = 1 / d, to_low = low - o, to_high = high - o;
    double t = to_low * per_d, u = to_high * per_d;
    return (box_slab){filter_lesser(t, u), filter_greater(t, u), to_low, to_high,
                      BOX_ORDERED(t, u)};
}

static inline bool box_is_still(double d)
{
    return bits_of(d) << 1 == (uint64_t){0};
}

static inline bool box_scales(double d)
{
    return box_is_still(d) | filter_scales(fabs(d), fabs(d), fabs(d));
}

typedef struct {
    box_slab x, y, z;
} box_terms;

static INLINED box_terms box_terms_of(const sure_ray *ray, const sure_box *box)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    return (box_terms){box_slab_of(o->x, d->x, box->low.x, box->high.x),
                       box_slab_of(o->y, d->y, box->low.y, box->high.y),
                       box_slab_of(o->z, d->z, box->low.z, box->high.z)};
}

/* Numbers that are less are less as they are stored, too, in any mode. */
static inline box_told box_is_thick(const sure_box *box)
{
    return BOX_LESS(box->low.x, box->high.x) & BOX_LESS(box->low.y, box->high.y) &
           BOX_LESS(box->low.z, box->high.z);
}

static inline box_told box_is_crossed(const box_terms *of)
{
    return of->x.crossed & of->y.crossed & of->z.crossed;
}

/* Is t certainly greater than u? */
static inline bool box_after(double t, double u)
{
    return t - u > BOX_SHARE * (fabs(t) + fabs(u)) + BOX_APART;
}

/* The last of three, and the last but one. */
static inline double box_last(double x, double y, double z, double *before)
{
    double later = filter_greater(x, y), sooner = filter_lesser(x, y);
    *before = filter_greater(sooner, filter_lesser(later, z));
    return filter_greater(later, z);
}

/* The first of three, and the second. */
static inline double box_soonest(double x, double y, double z, double *after)
{
    double later = filter_greater(x, y), sooner = filter_lesser(x, y);
    *after = filter_lesser(later, filter_greater(sooner, z));
    return filter_lesser(sooner, z);
}

/* From the last of the near planes to the first of the far ones; before and after: the last but one
 * and the second. What is infinite becomes BOX_NEVER, so that differences tell it apart. */
typedef struct {
    double enter, leave, before, after;
} box_chord;

static inline box_chord box_chord_of(const box_terms *of)
{
    const double never = (double){0} + BOX_NEVER;
    double before, after, enter = box_last(of->x.near, of->y.near, of->z.near, &before);
    double leave = box_soonest(of->x.far, of->y.far, of->z.far, &after);
    return (box_chord){.enter = filter_lesser(enter, never),
                       .leave = filter_greater(leave, -never),
                       .before = filter_greater(before, -never),
                       .after = filter_lesser(after, never)};
}

static inline bool box_misses(const box_chord *at)
{
    return box_after(at->enter, at->leave);
}

/* Are the ends, and which faces they are on, as they seem to be? */
static inline bool box_meets(const box_chord *at)
{
    return box_after(at->leave, at->enter) & box_after(at->enter, at->before) &
           box_after(at->after, at->leave);
}

static inline double box_error(double t)
{
    return BOX_SHARE * fabs(t) + BOX_FLOOR;
}

/* Are the numbers in the filter's range, and so valid but for t_min and t_max and the corners'
 * order? */
static inline bool box_in_range(const sure_ray *ray, const sure_box *box)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    double far = sum_of_magnitudes(o->x, o->y, o->z) +
                 sum_of_magnitudes(box->low.x, box->low.y, box->low.z) +
                 sum_of_magnitudes(box->high.x, box->high.y, box->high.z);
    bool moves = (bits_of(d->x) | bits_of(d->y) | bits_of(d->z)) << 1 != (uint64_t){0};
    return box_scales(d->x) & box_scales(d->y) & box_scales(d->z) & (far < BOX_FAR) & moves;
}

/* Faces are counted as the parts are: 2 axis, and 1 more for the high one. */
typedef struct {
    uint64_t enter, leave;
} box_faces;

/* The face that the line enters by, of the axis whose low one is `low`. */
static inline uint64_t box_first_face(double d, uint64_t low)
{
    return low + (bits_of(d) >> 63);
}

/* The one of x, y, z whose number is t. */
static inline uint64_t box_face_at(double t, double of_x, uint64_t x, double of_y, uint64_t y,
                                   uint64_t z)
{
    return filter_either_bits(filter_all(t == of_x), x,
                              filter_either_bits(filter_all(t == of_y), y, z));
}

static inline box_faces box_faces_of(const sure_ray *ray, const box_terms *of, const box_chord *at)
{
    const sure_vec3 *d = &ray->direction;
    const uint64_t zero = {0};
    uint64_t x = box_first_face(d->x, zero), y = box_first_face(d->y, zero + 2),
             z = box_first_face(d->z, zero + 4);
    return (box_faces){box_face_at(at->enter, of->x.near, x, of->y.near, y, z),
                       box_face_at(at->leave, of->x.far, x, of->y.far, y, z) ^ 1};
}

#ifndef LANES /* From here on of one ray alone, with branches. */

static inline int box_face(sure_part part)
{
    return (int)part - SURE_PART_X_MIN;
}

static inline sure_part box_part(int face)
{
    return (sure_part)(SURE_PART_X_MIN + face);
}

static inline double box_place(const sure_box *box, int face)
{
    const sure_vec3 *corner = face % 2 ? &box->high : &box->low;
    return face < 2 ? corner->x : face < 4 ? corner->y : corner->z;
}

static inline double box_along(const sure_vec3 *v, int face)
{
    return face < 2 ? v->x : face < 4 ? v->y : v->z;
}

/* The outward normal. */
static inline sure_vec3 box_outward(sure_part part)
{
    int face = box_face(part);
    double out = face % 2 ? 1 : -1;
    return (sure_vec3){face / 2 == 0 ? out : 0, face / 2 == 1 ? out : 0, face / 2 == 2 ? out : 0};
}

static inline filter_end box_end(double t, int face, end_kind at)
{
    return (filter_end){.t = t, .error = box_error(t), .end = {at, box_part(face)}};
}

static INLINED filter_verdict box_found(const sure_ray *ray, const box_terms *of,
                                        filter_interval *found)
{
    const box_chord at = box_chord_of(of);
    if (box_misses(&at))
        return filter_miss_if(true, ray);
    if (!box_meets(&at))
        return FILTER_UNCERTAIN;
    const box_faces faces = box_faces_of(ray, of, &at);
    found->enter = box_end(at.enter, (int)faces.enter, END_BASE);
    found->leave = box_end(at.leave, (int)faces.leave, END_TOP);
    return FILTER_INTERVAL;
}

static INLINED filter_verdict box_filter(const sure_ray *ray, const void *shape,
                                         filter_interval *found)
{
    const sure_box *box = (const sure_box *)shape;
    box_terms of = box_terms_of(ray, box);
    bool fits = box_in_range(ray, box) & BOX_TOLD(box_is_crossed(&of) & box_is_thick(box));
    return fits ? box_found(ray, &of, found) : FILTER_UNCERTAIN;
}

/* On the line's coordinate along the axis a face is as a plane is. A part at an edge whose plane is
 * not crossed tells none. */
static inline polish_step box_step(const sure_ray *ray, const void *shape, tagged_end end, double t)
{
    const sure_vec3 unit = {1, 0, 0};
    int face = box_face(end.part);
    sure_vec3 place = {box_place((const sure_box *)shape, face), 0, 0};
    sure_ray line = {
        {box_along(&ray->origin, face), 0, 0}, {box_along(&ray->direction, face), 0, 0}, 0, 0};
    return crossing_step(&line, &place, &unit, t);
}

/* Of an axis: where bits above the 61st are set d is neither 0 nor what filter_scales takes. */
static inline uint64_t box_scale_bits(double d)
{
    uint64_t bits = bits_of(d) << 1;
    return (bits - (bits_of(0x1p-255) << 1)) & bits_unknown(-(uint64_t)(bits != 0));
}

/* box_in_range and box_is_thick by what costs least where all is well, and of coordinates by how
 * far the planes are from the ray's start. */
static INLINED bool box_fits(const sure_ray *ray, const sure_box *box, const box_terms *of)
{
    const sure_vec3 *d = &ray->direction;
    double least = filter_lesser(filter_lesser(of->x.to_low, of->y.to_low), of->z.to_low);
    double most = filter_greater(filter_greater(of->x.to_high, of->y.to_high), of->z.to_high);
    return BOX_TOLD(box_is_crossed(of) & box_is_thick(box) & BOX_LESS(-BOX_FAR, least) &
                    BOX_LESS(most, BOX_FAR)) &&
           (box_scale_bits(d->x) | box_scale_bits(d->y) | box_scale_bits(d->z)) >> 62 == 0 &&
           (bits_of(d->x) | bits_of(d->y) | bits_of(d->z)) << 1 != 0;
}

/* Which of two t is the greater is certain when they are further apart; error: of either of them.
 */
#define BOX_CLEAR 0x1.1p1

/* box_found without a branch. Nothing is put in an infinity's place: of the two ends at least one
 * is finite, or there is no chord. */
static INLINED decided box_decide(const sure_ray *ray, const sure_box *box)
{
    const sure_vec3 *d = &ray->direction;
    const box_terms of = box_terms_of(ray, box);
    double before, after, enter = box_last(of.x.near, of.y.near, of.z.near, &before);
    /* Here the chord's first end is being worked out, which takes long. */
    if (!box_fits(ray, box, &of))
        return (decided){.certain = false};
    double leave = box_soonest(of.x.far, of.y.far, of.z.far, &after);
    const decision_end at = decision_end_of(enter, leave, ray);
    double other = filter_choose(filter_negative(at.start), after, before), error = box_error(at.t);
    double nearer = filter_lesser(filter_lesser(fabs(enter), fabs(leave)), BOX_NEVER);
    double gap = leave - enter, margin = BOX_CLEAR * BOX_SHARE * nearer + BOX_APART;
    uint64_t off_x =
        bits_of(filter_double_of(BOX_LESS(of.x.near, at.t) & BOX_LESS(at.t, of.x.far)));
    uint64_t off_y =
        bits_of(filter_double_of(BOX_LESS(of.y.near, at.t) & BOX_LESS(at.t, of.y.far)));
    uint64_t y_or_z = filter_either_bits(off_y, box_first_face(d->z, 4), box_first_face(d->y, 2));
    uint64_t face = filter_either_bits(off_x, y_or_z, box_first_face(d->x, 0));
    return decision_of(&at, gap, fabs(gap) > margin, fabs(at.t - other) > BOX_CLEAR * error,
                       box_error(enter), error, SURE_PART_X_MIN + (face ^ (at.leaves & 1)), ray);
}

#endif
