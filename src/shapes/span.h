/* SPDX-License-Identifier: MIT */
/* A closed object cuts one closed interval from a line, since all of them are convex. The answer is
 * read off that interval; faces are never tested one by one, which leaks rays at rims or counts
 * them twice. An end that is NaN makes the interval empty. */
#pragma once

#include "../numbers/real.h"
#include "../numbers/vec3.h"
#include "../stages/decision.h"

#include <surehit/object.h>

#include <stdbool.h>
#include <stddef.h>

#ifdef SURE_FLOAT32
typedef sure_float_ray real_ray;
#else
typedef sure_ray real_ray;
#endif

/* One by one, as a ray has mostly just been written: to load several then waits for the stores. */
#ifdef __GNUC__
#define SPAN_ONE_BY_ONE _Pragma("GCC unroll 8")
#else
#define SPAN_ONE_BY_ONE
#endif

static inline void span_round(const void *from, size_t count, float *to)
{
    const double *number = from;
    SPAN_ONE_BY_ONE
    for (size_t i = 0; i < count; i++)
        to[i] = (float)number[i];
}

/* A ray or a shape as the tier has it, the numbers of its struct in their order: rounded to `room`,
 * or as it is. */
static inline const void *span_real(const void *from, size_t count, void *room)
{
#ifdef SURE_FLOAT32
    span_round(from, count, room);
    return room;
#else
    (void)count, (void)room;
    return from;
#endif
}

#define SPAN_REALS(ray, shape)                                                                     \
    real_ray ray_room;                                                                             \
    real shape_room[SURE_SHAPE_NUMBERS];                                                           \
    const real_ray *line = span_real(ray, sizeof *(ray) / sizeof(double), &ray_room);              \
    const real *of = span_real(shape, sizeof *(shape) / sizeof(double), shape_room)

/* A field of such a shape. */
#define SPAN_NUMBER(of, shape, field) (of)[offsetof(sure_##shape, field) / sizeof(double)]
#define SPAN_VECTOR(of, shape, field) (*(const vec3 *)&SPAN_NUMBER(of, shape, field))

typedef struct {
    real enter, leave; /* the points t with enter <= t <= leave; none when not enter <= leave */
    sure_part enter_part, leave_part;
    bool endless;         /* the whole line: a chord without ends */
    bool boundary;        /* the line misses the interior: all of the chord is boundary, ... */
    sure_part inner_part; /* ... and this is its part between the ends */
} span;

static inline span span_empty(void)
{
    return (span){.enter = 1, .leave = 0};
}

/* The whole line, or what one surface of part `part` leaves of it. */
static inline span span_of(real enter, real leave, sure_part part)
{
    return (span){enter, leave, part, part, false, false, part};
}

static inline span span_line(sure_part part, bool boundary)
{
    return (span){-(real)INFINITY, (real)INFINITY, part, part, true, boundary, part};
}

/* `first` or `second` without a branch: which face an end is on is no predictor's guess. */
static inline sure_part span_either(bool is_first, sure_part first, sure_part second)
{
    unsigned difference = (unsigned)first ^ (unsigned)second;
    return (sure_part)((unsigned)second ^ (difference & (0u - (unsigned)is_first)));
}

/* What a solid's body and the slab between its end planes have in common. At a common end (a rim)
 * the point belongs to the cap, which is reported before the wall. */
static inline span span_within(span body, span slab)
{
    if (!(body.enter <= body.leave))
        return span_empty();
    bool body_enters = body.enter > slab.enter;
    bool body_leaves = body.leave < slab.leave;
    span both = body;
    both.enter = body.enter > slab.enter ? body.enter : slab.enter;
    both.leave = body.leave < slab.leave ? body.leave : slab.leave;
    both.enter_part = span_either(body_enters, body.enter_part, slab.enter_part);
    both.leave_part = span_either(body_leaves, body.leave_part, slab.leave_part);
    both.endless = body.endless && slab.endless;
    both.boundary = body.boundary || slab.boundary;
    if (slab.boundary) /* all of it lies in one cap */
        both.enter_part = both.leave_part = both.inner_part = slab.inner_part;
    if (both.enter == both.leave) /* one point, on whatever the two ends were on */
        both.enter_part = both.leave_part =
            both.enter_part < both.leave_part ? both.enter_part : both.leave_part;
    return both;
}

static inline sure_status span_answer(real t, sure_part part, int leaves, sure_hit *hit)
{
    *hit = (sure_hit){t, INFINITY, part, leaves};
    return SURE_HIT;
}

/* The first boundary point in [t_min, t_max]; an endless chord has no end. */
static inline sure_status span_hit(const span *chord, const real_ray *ray, sure_hit *hit)
{
    real t_min = ray->t_min, t_max = ray->t_max;
    if (!(chord->enter <= chord->leave))
        return SURE_MISS;
    if (t_min <= chord->enter)
        return chord->enter <= t_max ? span_answer(chord->enter, chord->enter_part, 0, hit)
                                     : SURE_MISS;
    if (chord->boundary && t_min < chord->leave)
        return span_answer(t_min, chord->inner_part, 0, hit);
    if (t_min <= chord->leave && chord->leave <= t_max && !chord->endless)
        return span_answer(chord->leave, chord->leave_part, !chord->boundary, hit);
    return SURE_MISS;
}

static inline sure_status span_interval(const span *chord, const real_ray *ray,
                                        sure_interval *interval)
{
    real t_min = ray->t_min, t_max = ray->t_max;
    if (!(chord->enter <= chord->leave && chord->enter <= t_max && t_min <= chord->leave))
        return SURE_MISS;
    *interval = (sure_interval){chord->enter, chord->leave, chord->enter_part, chord->leave_part};
    return SURE_HIT;
}

/* The first hit of a plain line: one whose chord has two ends with an interior between them or is a
 * point, and whose input is valid for sure. Hit or miss, and at which end, no predictor guesses,
 * and a wrong guess takes longer than the formulas; so all of them are worked out, without a
 * branch. Any other line is left to span_hit. */
typedef struct {
    bool met; /* the line meets the object, be it outside of [t_min, t_max] */
    real t;
    sure_part part;
    bool leaves; /* it is the second end */
} span_first;

/* An index is a load, which no compiler makes a branch. */
static inline real span_chosen(bool is_second, real first, real second)
{
    const real both[2] = {first, second};
    return both[is_second];
}

static inline real span_later(real t, real other)
{
    return t > other ? t : other;
}

static inline real span_earlier(real t, real other)
{
    return t < other ? t : other;
}

/* The end of a chord that answers, if one of them does. Neither is NaN. */
static inline real span_first_end(real enter, real leave, const real_ray *ray)
{
    return span_chosen(enter < ray->t_min, enter, leave);
}

static inline sure_status span_first_hit(const span_first *first, const real_ray *ray,
                                         sure_hit *hit)
{
    real t_min = ray->t_min, t_max = ray->t_max;
    bool hits = first->met & (t_min <= first->t) & (first->t <= t_max);
    hit_where(-(uint64_t)hits, (sure_hit){first->t, INFINITY, first->part, first->leaves}, hit);
    return hits ? SURE_HIT : SURE_MISS;
}

/* The contract's questions to one shape, answered from <shape>_span; <shape>_plain: whether the
 * line is plain, and its first hit if it is. */
#define SPAN_QUESTIONS(shape)                                                                      \
    static RARE sure_status shape##_any_hit(const sure_ray *ray, const sure_##shape *shape,        \
                                            sure_hit *hit)                                         \
    {                                                                                              \
        if (sure_##shape##_check(ray, shape) != SURE_FIELD_NONE)                                   \
            return SURE_INVALID;                                                                   \
        SPAN_REALS(ray, shape);                                                                    \
        span chord = shape##_span(line, of);                                                       \
        return span_hit(&chord, line, hit);                                                        \
    }                                                                                              \
    sure_status TIER(sure_##shape##_hit)(const sure_ray *ray, const sure_##shape *shape,           \
                                         sure_hit *hit)                                            \
    {                                                                                              \
        SPAN_REALS(ray, shape);                                                                    \
        span_first first;                                                                          \
        if (!shape##_plain(line, of, &first))                                                      \
            return shape##_any_hit(ray, shape, hit);                                               \
        return span_first_hit(&first, line, hit);                                                  \
    }                                                                                              \
    sure_status TIER(sure_##shape##_interval)(const sure_ray *ray, const sure_##shape *shape,      \
                                              sure_interval *interval)                             \
    {                                                                                              \
        if (sure_##shape##_check(ray, shape) != SURE_FIELD_NONE)                                   \
            return SURE_INVALID;                                                                   \
        SPAN_REALS(ray, shape);                                                                    \
        span chord = shape##_span(line, of);                                                       \
        return span_interval(&chord, line, interval);                                              \
    }                                                                                              \
    sure_status TIER(sure_##shape##_occluded)(const sure_ray *ray, const sure_##shape *shape)      \
    {                                                                                              \
        sure_hit unused;                                                                           \
        return TIER(sure_##shape##_hit)(ray, shape, &unused);                                      \
    }                                                                                              \
    SPAN_ROUNDED(shape)

/* Of what has been rounded before. */
typedef sure_status span_rounded_hit(const sure_float_ray *, const sure_float_object *, sure_hit *);
#define SPAN_DECLARE_ROUNDED(shape, SHAPE) span_rounded_hit shape##_rounded_hit;
SURE_EACH_SHAPE(SPAN_DECLARE_ROUNDED)

#ifdef SURE_FLOAT32
#define SPAN_ROUNDED(shape)                                                                        \
    sure_status shape##_rounded_hit(const sure_float_ray *ray, const sure_float_object *object,    \
                                    sure_hit *hit)                                                 \
    {                                                                                              \
        span_first first;                                                                          \
        if (!shape##_plain(ray, object->numbers, &first))                                          \
            return shape##_any_hit(ray->of, &object->of->as.shape, hit);                           \
        return span_first_hit(&first, ray, hit);                                                   \
    }
#else
#define SPAN_ROUNDED(shape)
#endif

/* o + t d as seen from `from`: the two differences of like size are taken first. */
static inline vec3 span_point(const sure_ray *ray, double t, sure_vec3 from)
{
    vec3 start = vec3_sub(vec3_from(ray->origin), vec3_from(from));
    return vec3_add(start, vec3_scale((real)t, vec3_from(ray->direction)));
}

/* The unit normal along `outward`; -d/|d| where that is no direction (a radius of 0, overflow). */
static INLINED sure_vec3 span_normal(vec3 outward, bool exists, const sure_ray *ray)
{
    if (!exists || !vec3_is_direction(outward))
        outward = vec3_negate(vec3_direction_from(ray->direction));
    return vec3_public(vec3_unit(outward));
}
