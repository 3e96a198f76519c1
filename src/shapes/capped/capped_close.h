/* SPDX-License-Identifier: MIT */
/* What cylinder and cone share in double-doubles. */
#pragma once

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

#define CAPPED_CLOSE(shape)                                                                        \
    .step = shape##_step, .discriminant = shape##_discriminant_of_dd, .filter = shape##_closely,   \
    .spawn = shape##_spawn_quick
