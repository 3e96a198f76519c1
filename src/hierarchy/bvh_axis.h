/* SPDX-License-Identifier: MIT */
/* A ray and the faces of a box across one axis; behind shapes/lanes/lanes.h several rays. What is
 * computed here docs/proofs/bvh.md proves. */
#pragma once

#include "../numbers/bits.h"

#include <surehit/bounds.h>

#include <math.h>
#include <stdbool.h>

/* (face - o) / d is off by four roundings of 2^-52 at most where it is positive. */
#define WALK_NEAR (1 - 0x1p-49)
#define WALK_FAR (1 + 0x1p-49)
/* Components that can be divided by. */
#define WALK_LEAST 0x1p-900
#define WALK_MOST 0x1p900
/* More than anything that is flushed: of a quotient, and of what is divided. */
#define WALK_FLUSHED 0x1p-960
#define WALK_FLUSHED_FACE 0x1p-1000

/* Along an axis that the ray doesn't move along the quotients are infinite or NaNs; where they
 * can't be known NaNs, and these bound nothing. */
typedef struct {
    double o, to_near, to_far; /* 1/d, less and more */
    double slack;              /* of t, for what is flushed: at least so much */
    bool down;                 /* the face of the greater coordinate is met first */
} bvh_axis;

static inline double bvh_where(bool condition, double x, double y)
{
#ifdef LANES
    return double_of((bits_of(x) & (uint64_t)condition) | (bits_of(y) & ~(uint64_t)condition));
#else
    return condition ? x : y;
#endif
}

/* The greater of x and what is known; that where x is a NaN. */
static inline double bvh_later(double x, double known)
{
#ifdef LANES
    return filter_greater(x, known);
#else
    return x > known ? x : known;
#endif
}

static inline double bvh_earlier(double x, double known)
{
#ifdef LANES
    return filter_lesser(x, known);
#else
    return x < known ? x : known;
#endif
}

/* Where the ray crosses a face. */
static inline double bvh_at(double face, double o, double per)
{
    return (face - o) * per;
}

static inline bvh_axis bvh_axis_of(double o, double d)
{
    const double zero = {0};
    double size = fabs(d), per = 1 / d;
    bool moves = (size > WALK_LEAST) & (size < WALK_MOST), near = (fabs(o) > SURE_BVH_FAR) ^ true;
    bool slow = moves & (fabs(o) < 0x1p-1022); /* to multiply with, on some processors */
    bool still = (bits_of(d) << 1 == (uint64_t){0}) & near;
    per = bvh_where(moves & near, per, bvh_where(still, zero + INFINITY, zero + NAN));
    return (bvh_axis){
        .o = bvh_where(slow, zero, o),
        .to_near = per * WALK_NEAR,
        .to_far = per * WALK_FAR,
        .slack = bvh_where(moves, fabs(per) * WALK_FLUSHED_FACE, zero),
        .down = per < zero,
    };
}
