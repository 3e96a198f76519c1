/* SPDX-License-Identifier: MIT */
/* The box around an object. A disc of radius r across the axis A reaches
 *
 *     e_i = r sqrt((A_j^2 + A_k^2) / A.A)
 *
 * to either side of its centre along coordinate i. A cylinder is spanned by two discs, a cone by
 * one and its apex: both are convex. The proof is docs/proofs/bvh.md. */
#pragma once

#include "../numbers/bits.h"

#include <surehit/bounds.h>
#include <surehit/vector.h>

#include <math.h>
#include <stdbool.h>

/* More than the roundings of e_i, some eight of 2^-52, and than what is flushed in its squares. */
#define REACH_SHARE (1 + 0x1p-48)
#define REACH_MORE 0x1p-60
/* Out of this range squares are not known; then r itself is reach enough. */
#define REACH_LEAST 0x1p-900
#define REACH_MOST 0x1p1000

/* More than is flushed on the way to a face, two numbers of less than 2^-1022. */
#define REACH_FLUSHED 0x1p-960

/* Where something that rounds to x may lie: a double further, in any rounding mode. */
static inline double bounds_above(double x)
{
    double further = x + (fabs(x) * 0x1p-52 + REACH_FLUSHED);
    return further > SURE_BVH_FAR ? INFINITY : further < -SURE_BVH_FAR ? -SURE_BVH_FAR : further;
}

static inline double bounds_below(double x)
{
    return -bounds_above(-x);
}

/* Makes the box larger where it has to be. */
static inline void bounds_include(sure_vec3 p, const double reach[3], double low[3], double high[3])
{
    const double at[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; i++) {
        double least = bounds_below(at[i] - reach[i]), most = bounds_above(at[i] + reach[i]);
        low[i] = least < low[i] ? least : low[i];
        high[i] = most > high[i] ? most : high[i];
    }
}

static inline void bounds_reach_of_disc(sure_vec3 axis, double r, double reach[3])
{
    const double square[3] = {axis.x * axis.x, axis.y * axis.y, axis.z * axis.z};
    double whole = square[0] + square[1] + square[2];
    bool known = whole > REACH_LEAST && whole < REACH_MOST;
    for (int i = 0; i < 3; i++) {
        double across = square[(i + 1) % 3] + square[(i + 2) % 3];
        double share = known ? REACH_SHARE * sqrt(across / whole) + REACH_MORE : 1;
        reach[i] = share < 1 ? r * share : r;
    }
}
