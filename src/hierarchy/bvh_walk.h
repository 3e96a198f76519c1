/* SPDX-License-Identifier: MIT */
/* Does a ray meet boxes? Never no where it does: docs/proofs/bvh.md counts the roundings, in
 * any mode, subnormals flushed or not. More often than it does yes costs time alone. */
#pragma once

#include "../numbers/bits.h"

#include <surehit/bvh.h>
#include <surehit/ray.h>

#include <float.h>
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

/* A row of a node's bounds by its place in bytes, so that no node has an index to multiply. */
static inline size_t bvh_row_at(int row)
{
    return (size_t)row * SURE_BVH_WIDTH * sizeof(double);
}

static inline const double *bvh_row(const sure_bvh_node *node, size_t at)
{
    return (const double *)((const char *)node->bound + at);
}

/* A ray as boxes are asked about it. Along an axis that it doesn't move along the quotients are
 * infinite or NaNs; where they can't be known NaNs, and these bound nothing. */
typedef struct {
    double o[3], to_near[3], to_far[3]; /* 1/d, less and more */
    size_t near[3], far[3];             /* bvh_row's */
    double t_min;
    double slack; /* of t, for what is flushed */
} bvh_probe;

static inline bvh_probe bvh_probe_of(const sure_ray *ray)
{
    const double o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    bvh_probe probe; /* nothing is set twice: that takes time here */
    probe.t_min = ray->t_min;
    probe.slack = WALK_FLUSHED;
    for (int i = 0; i < 3; i++) {
        double size = fabs(d[i]), per = 1 / d[i];
        bool moves = size > WALK_LEAST && size < WALK_MOST;
        bool slow = moves && fabs(o[i]) < DBL_MIN; /* to multiply with, on some processors */
        probe.o[i] = slow ? 0 : o[i];
        if (!moves || fabs(o[i]) > SURE_BVH_FAR)
            per = is_zero_bits(d[i]) && fabs(o[i]) <= SURE_BVH_FAR ? INFINITY : NAN;
        bool down = per < 0;
        probe.near[i] = bvh_row_at(2 * i + down);
        probe.far[i] = bvh_row_at(2 * i + !down);
        probe.to_near[i] = per * WALK_NEAR;
        probe.to_far[i] = per * WALK_FAR;
        if (moves && fabs(per) * WALK_FLUSHED_FACE > probe.slack)
            probe.slack = fabs(per) * WALK_FLUSHED_FACE;
    }
    return probe;
}

/* The greater of x and what is known; that where x is a NaN. */
static inline double bvh_later(double x, double known)
{
    return x > known ? x : known;
}

static inline double bvh_earlier(double x, double known)
{
    return x < known ? x : known;
}

/* Left a loop by what stands before it, the compiler takes several children at a time. */
#ifdef __GNUC__
#define BVH_LANES _Pragma("GCC unroll 1")
#else
#define BVH_LANES
#endif

/* Compiled twice, and the wider one taken where the processor has it: the same operations, four
 * children at a time. */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__)
#define BVH_WIDE __attribute__((target_clones("avx2", "default")))
#define BVH_WITHIN inline __attribute__((always_inline)) /* its asking is part of both */
#else
#define BVH_WIDE
#define BVH_WITHIN inline
#endif

/* Where the ray meets the children's boxes, up to t_max; 0 for one that it doesn't meet, else all
 * ones. */
static inline void bvh_meets(const sure_bvh_node *node, const bvh_probe *probe, double t_max,
                             double enter[SURE_BVH_WIDTH], uint64_t meets[SURE_BVH_WIDTH])
{
    const double *near_x = bvh_row(node, probe->near[0]), *far_x = bvh_row(node, probe->far[0]);
    const double *near_y = bvh_row(node, probe->near[1]), *far_y = bvh_row(node, probe->far[1]);
    const double *near_z = bvh_row(node, probe->near[2]), *far_z = bvh_row(node, probe->far[2]);
    const double *o = probe->o, *to_near = probe->to_near, *to_far = probe->to_far;
    BVH_LANES
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        double from = bvh_later((near_x[k] - o[0]) * to_near[0], probe->t_min);
        from = bvh_later((near_y[k] - o[1]) * to_near[1], from);
        enter[k] = bvh_later((near_z[k] - o[2]) * to_near[2], from);
        double to = bvh_earlier((far_x[k] - o[0]) * to_far[0], t_max);
        to = bvh_earlier((far_y[k] - o[1]) * to_far[1], to);
        double leave = bvh_earlier((far_z[k] - o[2]) * to_far[2], to) + probe->slack;
        meets[k] = enter[k] <= leave ? UINT64_MAX : 0;
    }
}
