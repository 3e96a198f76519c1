/* SPDX-License-Identifier: MIT */
/* The first stage: double arithmetic with proven bounds. It answers for certain or not at all, in
 * every rounding mode and with subnormals flushed: all bounds count 2^-52 for an operation, and
 * ranges outside which they would not hold are refused. A difference that is greater than a double
 * once rounded is greater before, in every mode: that is how ends are compared. */
#pragma once

#ifndef LANES
#include "../numbers/bits.h"
#include "../numbers/dd.h"
#endif

#include "../numbers/number.h"

#include <surehit/bounds.h>
#include <surehit/ray.h>

#include <stdbool.h>

/* A double as one of the numbers of number.h. */
typedef double f64;
typedef no_context f64_context;

NUMBER_OPERATION(f64, of, x, f64 x)
NUMBER_OPERATION(f64, difference_of, x - y, f64 x, f64 y)
NUMBER_OPERATION(f64, negate, -x, f64 x)
NUMBER_OPERATION(f64, add, x + y, f64 x, f64 y)
NUMBER_OPERATION(f64, sub, x - y, f64 x, f64 y)
NUMBER_OPERATION(f64, mul, (x) * (y), f64 x, f64 y)
NUMBER_OPERATION(f64, square, (x) * (x), f64 x)

#define NUMBER f64
#define NUMBER_HAS_SUB
#include "../numbers/vector_tmpl.h"
#undef NUMBER_HAS_SUB

/* The interval that a line shares with a closed convex shape, by name: which points of the line its
 * two ends are. Names can be certain where numbers are rounded, so this is what every stage of
 * `certain` and `exact` decides; numbers come afterwards. */
typedef enum {
    END_LESS,    /* the lesser root of the body's quadratic, or its only one */
    END_MORE,    /* the greater root */
    END_BASE,    /* where the line crosses the base's plane; the plane or the disc itself */
    END_TOP,     /* ... the plane of the top, or through the apex */
    END_START,   /* t_min, on a chord that is boundary as a whole */
    END_TANGENT, /* both roots in one, the vertex -b/a */
    END_ENDLESS, /* no point: a line within a plane has no ends */
} end_kind;

typedef struct {
    end_kind at;
    sure_part part;
} tagged_end;

typedef struct {
    bool empty;
    bool boundary;        /* the line misses the interior: all of the chord is boundary, ... */
    sure_part inner_part; /* ... and this is its part between the ends */
    tagged_end enter, leave;
} tagged_interval;

static inline tagged_interval interval_empty(void)
{
    return (tagged_interval){.empty = true};
}

static inline tagged_interval interval_between(tagged_end enter, tagged_end leave)
{
    return (tagged_interval){.enter = enter, .leave = leave};
}

static inline tagged_interval interval_point(tagged_end only)
{
    return interval_between(only, only);
}

/* A chord in the boundary. */
static inline tagged_interval interval_along(tagged_end enter, tagged_end leave,
                                             sure_part inner_part)
{
    return (tagged_interval){
        .boundary = true, .inner_part = inner_part, .enter = enter, .leave = leave};
}

/* The whole line lies in the boundary. */
static inline tagged_interval interval_endless(sure_part part)
{
    const tagged_end none = {END_ENDLESS, part};
    return interval_along(none, none, part);
}

typedef enum { FILTER_UNCERTAIN, FILTER_MISS, FILTER_INTERVAL } filter_verdict;

/* An end of the chord: |t - t*| <= error. */
typedef struct {
    double t, error;
    tagged_end end;
} filter_end;

/* A chord that meets the interior, both ends certain. */
typedef struct {
    filter_end enter, leave;
} filter_interval;

/* The reduced discriminant D, where a filter is given it (discriminant.c), of certain sign:
 * |value + rest - D| <= error, |rest| <= 2^-53 |value|. */
typedef struct {
    double value, rest, error; /* all 0 for a tangent */
    bool vanishes;             /* both of its terms are 0: a cone's apex, a cylinder's axis */
    bool coplanar;             /* the line is known to be in an end plane */
    sure_stage stage;
} known_discriminant;

/* What <shape>_filter answers: FILTER_INTERVAL with origin, direction and object certainly valid,
 * or FILTER_MISS with the range valid too. An interval's range is left to what reads it, below; the
 * flat shapes' may answer FILTER_MISS where the crossing is before t_min. */

/* The bits of a double where doubles are computed: what is waited for is chosen there, for it is a
 * long way to integers' registers and back. Of GCC on x86-64 alone. */
#if defined(__SSE2__) && !defined(__clang__) && !defined(LANES) && !defined(double)
typedef uint64_t filter_bits __attribute__((vector_size(16)));
#define FILTER_PAIR /* a double and what is beside it */

static INLINED filter_bits filter_bits_of(double x)
{
    filter_bits bits;
    __asm__("" : "=x"(bits) : "0"(x));
    return bits;
}

static INLINED double filter_double_of(filter_bits bits)
{
    double x;
    __asm__("" : "=x"(x) : "0"(bits));
    return x;
}
#else
typedef uint64_t filter_bits;
#define filter_bits_of bits_of
#define filter_double_of double_of
#endif

#define FILTER_ONE UINT64_C(0x3ff0000000000000) /* the bits of 1 */

/* All ones where x is negative, -0, too. */
static INLINED filter_bits filter_negative(double x)
{
    return -(filter_bits_of(x) >> 63);
}

static INLINED double filter_choose(filter_bits mask, double x, double y)
{
    return filter_double_of((filter_bits_of(x) & mask) | (filter_bits_of(y) & ~mask));
}

/* All ones where it holds, else 0. What is as good as random is chosen by it and by no branch. */
static inline uint64_t filter_all(bool condition)
{
#ifdef LANES
    return (uint64_t)condition;
#else
    return bits_unknown(-(uint64_t)condition);
#endif
}

static inline uint64_t filter_either_bits(uint64_t mask, uint64_t x, uint64_t y)
{
    return (x & mask) | (y & ~mask);
}

#ifndef LANES /* which has its own */
static inline double filter_either(uint64_t mask, double x, double y)
{
    return double_of(filter_either_bits(mask, bits_of(x), bits_of(y)));
}

static inline double filter_lesser(double x, double y)
{
    return x < y ? x : y;
}

static inline double filter_greater(double x, double y)
{
    return x > y ? x : y;
}
#endif

#define FILTER_ENDLESS UINT64_C(0x7ff0000000000000)

/* Is the range valid and free of -0? By bits, which flushing does not change: among doubles that
 * are not negative their order is that of integers. */
static inline bool filter_range(const sure_ray *ray)
{
    uint64_t least = bits_of(ray->t_min), most = bits_of(ray->t_max);
#ifdef LANES_UNSIGNED
    return (least < FILTER_ENDLESS) & (most <= FILTER_ENDLESS) & (least <= most);
#else /* a difference that is negative says no */
    return (int64_t)(least | (most - least) | (FILTER_ENDLESS - most) |
                     (FILTER_ENDLESS - 1 - least)) >= 0;
#endif
}

/* How far bits lie above those of `least`. */
#define FILTER_ABOVE(x, least) (bits_of(x) - bits_of(least))

/* 2^-255 <= x, y, z < 2^257: far enough from over- and underflow for products of three such
 * numbers. Not for a NaN or a negative number. Bits of more numbers may be or-ed. */
static inline uint64_t filter_scale_bits(double x, double y, double z)
{
    return FILTER_ABOVE(x, 0x1p-255) | FILTER_ABOVE(y, 0x1p-255) | FILTER_ABOVE(z, 0x1p-255);
}

static inline bool filter_has_scale(uint64_t bits)
{
    return (bits & UINT64_C(7) << 61) == 0;
}

static inline bool filter_scales(double x, double y, double z)
{
    return filter_has_scale(filter_scale_bits(x, y, z));
}

/* 1/x or up to 9/8 of it, without a division. Let x = 2^e (1 + f): the difference of bits is
 * 2^-e (1 - f/2), which is no less than 2^-e / (1 + f). x: positive, normal, 1/x too. */
static inline double filter_reciprocal_above(double x)
{
    return filter_double_of(2 * FILTER_ONE - filter_bits_of(x));
}

/* |t - t*| <= error <= t: what t is off by at most, with what its sum and difference with this
 * round. They are beyond t*, and where both become the same float t* does (stages/floats.h). */
static inline double filter_float_off(double t, double error)
{
    return error + 0x1p-51 * t;
}

static inline double sum_of_magnitudes(double x, double y, double z)
{
    return fabs(x) + fabs(y) + fabs(z);
}

#ifndef LANES /* From here on of one ray alone, with branches. */

static inline filter_verdict filter_miss_if(bool certain, const sure_ray *ray)
{
    return certain && filter_range(ray) ? FILTER_MISS : FILTER_UNCERTAIN;
}

static inline filter_end filter_either_end(uint64_t mask, const filter_end *x, const filter_end *y)
{
    return (filter_end){
        filter_either(mask, x->t, y->t),
        filter_either(mask, x->error, y->error),
        {(end_kind)filter_either_bits(mask, x->end.at, y->end.at),
         (sure_part)filter_either_bits(mask, x->end.part, y->end.part)},
    };
}

/* The first end in [t_min, t_max]; FILTER_INTERVAL when it is certain. Which of the two it is is as
 * good as random where rays start within, so that is no branch. A finite t between t_min and t_max
 * shows that the range is valid, but for t_min's sign. */
static INLINED filter_verdict filter_first(const filter_interval *found, const sure_ray *ray,
                                           filter_end *first)
{
    const filter_end *enter = &found->enter, *leave = &found->leave;
    double t_min = ray->t_min, t_max = ray->t_max;
    uint64_t ahead = filter_all(enter->t - t_min > enter->error);
    bool behind = t_min - enter->t > enter->error;
    *first = filter_either_end(ahead, enter, leave);
    bool follows = first->t - t_min > first->error;
    if ((ahead | (uint64_t)(behind & follows)) == 0)
        return filter_miss_if(behind & (t_min - leave->t > leave->error), ray);
    if (t_max - first->t > first->error && !is_negative_bits(t_min))
        return FILTER_INTERVAL;
    return filter_miss_if(first->t - t_max > first->error, ray);
}

/* The hit at the first end in the range. The ray leaves a solid by the second end, which is then
 * certainly the greater. Entry: first as it is found, not rounded. */
static inline sure_hit filter_hit(const filter_interval *found, const filter_end *first)
{
    return (sure_hit){first->t, first->error, first->end.part, first->t > found->enter.t};
}

/* Is it known to be at 0? */
static inline bool filter_at_start(const filter_end *end)
{
    return is_zero_bits(end->t) && is_zero_bits(end->error);
}

/* filter_first where that may be, of either end: the other one is certainly on one side of it. */
static inline filter_verdict filter_first_known(const filter_interval *found, const sure_ray *ray,
                                                filter_end *first)
{
    *first = filter_at_start(&found->leave) ? found->leave : found->enter;
    if (filter_at_start(first) && bits_of(ray->t_min) == 0 && filter_range(ray))
        return FILTER_INTERVAL;
    return filter_first(found, ray, first);
}

/* Have the chord and [t_min, t_max] a point in common? FILTER_INTERVAL when they certainly have. */
static inline filter_verdict filter_meets(const filter_interval *found, const sure_ray *ray)
{
    if (!filter_range(ray))
        return FILTER_UNCERTAIN;
    double before = found->enter.t - ray->t_max, after = ray->t_min - found->leave.t;
    if (before > found->enter.error || after > found->leave.error)
        return FILTER_MISS;
    return -before > found->enter.error && -after > found->leave.error ? FILTER_INTERVAL
                                                                       : FILTER_UNCERTAIN;
}

/* A hit's t, correctly rounded: one or two of Newton's steps from the approximation, with the
 * residual in twice the precision, and a bound on what is left. Where the bound does not tell how t
 * is rounded, the next stage does. docs/proofs/polish.md proves the bounds; all count 2^-53 for an
 * operation, so round to nearest is required, but not that subnormals are kept. */

/* x = o + t d - from, one component: |x - (head + tail)| <= 4 2^-106 most, |tail| <= 2^-51 most,
 * where most is |o - from| + |t d|. */
static INLINED dd polish_component_of(double o, double from, double t, double d, double *most)
{
    dd start = two_sum(o, -from), way = two_product(t, d);
    dd x = two_sum(start.head, way.head);
    *most = fabs(start.head) + fabs(way.head);
    return (dd){x.head, x.tail + (start.tail + way.tail)};
}

typedef struct {
    dd x, y, z;
    double most; /* of all three */
} polish_point;

static INLINED polish_point polish_point_of(const sure_ray *ray, const sure_vec3 *from, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    double x_most, y_most, z_most;
    dd x = polish_component_of(o->x, from->x, t, d->x, &x_most);
    dd y = polish_component_of(o->y, from->y, t, d->y, &y_most);
    dd z = polish_component_of(o->z, from->z, t, d->z, &z_most);
    return (polish_point){x, y, z, x_most + y_most + z_most};
}

static inline vector_dd polish_vector(const polish_point *p)
{
    return (vector_dd){p->x, p->y, p->z};
}

/* The most that a step may bend, |a step|, as a share of the slope. */
#define POLISH_BEND 0x1p-6

/* |t* - (t + step)| <= error, of which the rounding of step -+ error is a part; when certain. */
typedef struct {
    double step, error;
    bool certain;
} polish_step;

/* t* rounded; true if the error does not matter. Rounding is monotone: what both ends of an
 * interval are rounded to, all of it is, ties and powers of two included. */
static inline bool polish_round(double t, polish_step way, double *rounded)
{
    double low = t + (way.step - way.error), high = t + (way.step + way.error);
    *rounded = low;
    return way.certain && low == high && fabs(low) >= 0x1p-960 && fabs(low) <= 0x1p960;
}

/* A shape's step from a t near an end to it. */
typedef polish_step polish_stepping(const sure_ray *ray, const void *shape, tagged_end end,
                                    double t);

/* t* correctly rounded, or false: by a step, or two of them. end: one known to be the answer, its t
 * nearly known. Entry: round to nearest. */
static INLINED bool polish(polish_stepping *step, int steps, const sure_ray *ray, const void *shape,
                           const filter_end *end, double *t)
{
    polish_step first = step(ray, shape, end->end, end->t);
    if (polish_round(end->t, first, t))
        return true;
    double nearer = end->t + first.step;
    return steps > 1 && polish_round(nearer, step(ray, shape, end->end, nearer), t);
}

#endif
