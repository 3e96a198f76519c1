/* SPDX-License-Identifier: MIT */
/* What the first stages of cylinder and cone share. The line is in the wall's body for t in [less,
 * more] and between the end planes for t in [low, high]; the chord is what these have in common.
 * docs/proofs/axial_filter.md proves what is said here.
 *
 * Which end is nearer is as good as random, so that is no branch: sign bits are spread into masks.
 * */
#pragma once

#include "../../stages/filter.h"

#ifndef LANES
#include "../../stages/decision.h"

#include <math.h>
#endif

/* The square of a discriminant that is of no account: what underflows is less. */
#define AXIAL_FLOOR 0x1p-900

/* Of no account either: it keeps A.d from being 0. */
#define AXIAL_TILT 0x1p-200

/* The contract's limit 2^-24 for t_error |d| by its measure of distance, for which size may stand
 * when divided by sqrt(2). */
#define AXIAL_LIMIT 0x1.6p-25

/* In errors of both intervals: with ends that are farther apart, their order is right. */
#define AXIAL_MARGIN 4

/* The root of x or up to 17/16 of it: halved bits are the chord of a concave function. */
static inline double filter_root_above(double x)
{
    return filter_double_of((filter_bits_of(x) >> 1) + (FILTER_ONE >> 1));
}

/* The root of x y / z, from 16/17 of it to 12/11: bits are, but for a scale, logarithms that are at
 * most 0.0861 (of 2) too low. The bound that x is made of has been multiplied by 17/16. A
 * negative z has no root: of its sign would come subnormal numbers, which are slow. */
static inline double axial_root(double x, double y, double z)
{
    return double_of(((bits_of(x) + bits_of(y) - bits_of(fabs(z))) >> 1) + (FILTER_ONE >> 1));
}

/* All ones for a negative number, else zero. */
static inline uint64_t filter_mask(double x)
{
    return -(bits_of(x) >> 63);
}

/* Are r in [2^-64, 2^192), H and size^2 in [2^-128, 2^128) and d.d in [2^-64, 2^64)? Not for a NaN
 * or a negative number. */
static inline bool axial_scales(double r, double height, double size, double d_d)
{
    return (FILTER_ABOVE(r, 0x1p-64) | FILTER_ABOVE(height, 0x1p-128) |
            FILTER_ABOVE(size, 0x1p-128) | FILTER_ABOVE(d_d * d_d, 0x1p-128)) >>
               60 ==
           0;
}

/* What both begin with. D = inner - outer as doubles have it; it is certain when its square is more
 * than `certain`. */
typedef struct axial_terms {
    vector_f64 axis, m, d;
    double height, d_d, size;
    double slant, a; /* K, of a cone; of a cylinder */
    double measure;  /* G, what D is measured by */
    double inner, outer, certain;
} axial_terms;

static inline double axial_discriminant(const axial_terms *of)
{
    return of->inner - of->outer;
}

/* Of a D as doubles have it. */
static inline bool axial_is_certain(const axial_terms *of, double discriminant)
{
    return discriminant * discriminant > of->certain;
}

/* Are the numbers in the filter's range, and so valid but for t_min and t_max? */
static inline bool axial_fits(const axial_terms *of, double radius)
{
    return axial_scales(radius, of->height, of->size, of->d_d);
}

typedef struct {
    double less, more;         /* where the wall's body begins and ends; -infinity, +infinity */
    end_kind less_at, more_at; /* which roots these are, of one ray alone */
    double e;                  /* A.d, A from the END_BASE plane to the other: > 0 for base < top */
    double base, top;          /* where the end planes are crossed */
    double wall_error, plane_error;
    bool leading; /* the sign of the wall's leading coefficient is certain */
} axial_line;

/* How far the ends of the two intervals are apart: of [low, high] from [less, more]. */
typedef struct {
    double before, after; /* low - less, more - high */
    double common,
        across; /* the length that both have in common, if it is not negative; high - low */
} axial_gaps;

static inline double axial_low(const axial_line *l)
{
    return filter_lesser(l->base, l->top);
}

static inline double axial_high(const axial_line *l)
{
    return filter_greater(l->base, l->top);
}

static inline axial_gaps axial_gaps_of(const axial_line *l)
{
    double low = axial_low(l), high = axial_high(l);
    return (axial_gaps){low - l->less, l->more - high, filter_lesser(high - l->less, l->more - low),
                        high - low};
}

/* Numbers are off by the error where the object is. Far from it they may be off by more, but the
 * margin is enough to know that the chord is not there; and within the limit the signs of
 * A.d, if a plane is an end, and of the wall's leading coefficient are right. */
static inline double axial_margin(const axial_line *l)
{
    return AXIAL_MARGIN * (l->wall_error + l->plane_error);
}

/* Where nothing is in common. */
static inline bool axial_misses(const axial_line *l, const axial_gaps *gaps)
{
    return (-gaps->common > axial_margin(l)) & l->leading;
}

/* Where something is: are the ends what they seem to be, and known within the limit? */
static inline bool axial_meets(const axial_line *l, const axial_gaps *gaps, double d_d, double size)
{
    double clear = filter_lesser(fabs(gaps->before), fabs(gaps->after));
    clear = filter_lesser(clear, filter_lesser(gaps->common, gaps->across));
    filter_bits walls = filter_negative(gaps->before) & filter_negative(gaps->after);
    double error = filter_choose(walls, l->wall_error, l->wall_error + l->plane_error);
    return (clear > axial_margin(l)) & (error * error * d_d < AXIAL_LIMIT * AXIAL_LIMIT * size);
}

/* An end is on the wall where `beyond` is negative, else on a plane: the base's where `base` is
 * set. */
static inline double axial_end_error(const axial_line *l, double beyond)
{
    return filter_either(filter_mask(beyond), l->wall_error, l->plane_error);
}

static inline uint64_t axial_end_part(double beyond, uint64_t base)
{
    uint64_t wall = filter_mask(beyond);
    return (wall & SURE_PART_WALL) | (~wall & (SURE_PART_TOP - (base & 1)));
}

#ifndef LANES /* From here on of one ray alone, with branches. */

/* A touch, or what the error of a known D makes of that of t: `share` is dt/dD times 2. */
static inline void axial_known(const known_discriminant *known, double error, double share,
                               axial_line *line)
{
    if (known->value == 0)
        line->less_at = line->more_at = END_TANGENT;
    else
        line->wall_error += error * share;
}

/* In an end plane the line is between the planes all along, as it were in the middle. */
static inline void axial_level(axial_line *line)
{
    line->base = -0x1p600;
    line->top = 0x1p600;
    line->plane_error = 0;
}

static inline filter_end axial_end(const axial_line *l, double t, double beyond, end_kind wall_at,
                                   uint64_t base)
{
    uint64_t wall = filter_mask(beyond), at = END_TOP - (base & 1);
    return (filter_end){
        t,
        axial_end_error(l, beyond),
        {(end_kind)((wall & wall_at) | (~wall & at)), (sure_part)axial_end_part(beyond, base)}};
}

static INLINED filter_verdict axial_decide(const axial_line *l, axial_gaps gaps, double d_d,
                                           double size, const sure_ray *ray, filter_interval *found)
{
    if (gaps.common < 0)
        return filter_miss_if(axial_misses(l, &gaps), ray);
    if (!axial_meets(l, &gaps, d_d, size))
        return FILTER_UNCERTAIN;
    uint64_t down = filter_mask(l->e);
    double enter = filter_greater(axial_low(l), l->less);
    double leave = filter_lesser(axial_high(l), l->more);
    found->enter = axial_end(l, enter, gaps.before, l->less_at, ~down);
    found->leave = axial_end(l, leave, gaps.after, l->more_at, down);
    return FILTER_INTERVAL;
}

static inline filter_verdict axial_chord(const axial_line *l, double d_d, double size,
                                         const sure_ray *ray, filter_interval *found)
{
    return axial_decide(l, axial_gaps_of(l), d_d, size, ray, found);
}

/* axial_decide and filter_first without a branch: the end is chosen before what it is is told. */
static INLINED decided axial_answer(const axial_line *l, double d_d, double size,
                                    const sure_ray *ray)
{
    const axial_gaps gaps = axial_gaps_of(l);
    const decision_end at = decision_end_of(filter_greater(axial_low(l), l->less),
                                            filter_lesser(axial_high(l), l->more), ray);
    double beyond = filter_either(at.leaves, gaps.after, gaps.before);
    return decision_of(&at, gaps.common, axial_meets(l, &gaps, d_d, size) | axial_misses(l, &gaps),
                       true, axial_end_error(l, gaps.before), axial_end_error(l, beyond),
                       axial_end_part(beyond, ~(filter_mask(l->e) ^ at.leaves)), ray);
}

#endif
