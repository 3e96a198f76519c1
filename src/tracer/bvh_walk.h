/* Does a ray meet boxes? Never no where it does: docs/proofs/bvh.md counts the roundings, in
 * any mode, subnormals flushed or not. More often than it does yes costs time alone. */
#ifndef TRACER_BVH_WALK_H
#define TRACER_BVH_WALK_H

#include "../arithmetic/bits.h"

#include <surehit/bvh.h>
#include <surehit/ray.h>

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

/* A ray as boxes are asked about it. Along an axis that it doesn't move along the quotients are
 * infinite or NaNs; where they can't be known NaNs, and these bound nothing. */
typedef struct {
    double o[3], to_near[3], to_far[3]; /* 1/d, less and more */
    int near[3];                        /* rows of sure_bvh_node's bounds */
    double t_min;
    double slack; /* of t, for what is flushed */
} bvh_probe;

static inline bvh_probe bvh_probe_of(const sure_ray *ray)
{
    const double o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    bvh_probe probe = {.t_min = ray->t_min, .slack = WALK_FLUSHED};
    for (int i = 0; i < 3; i++) {
        double size = fabs(d[i]), per = 1 / d[i];
        bool moves = size > WALK_LEAST && size < WALK_MOST;
        probe.o[i] = o[i];
        if (!moves || fabs(o[i]) > SURE_BVH_FAR)
            per = is_zero_bits(d[i]) && fabs(o[i]) <= SURE_BVH_FAR ? INFINITY : NAN;
        probe.near[i] = 2 * i + (per < 0);
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

/* Where the ray meets the children's boxes, up to t_max; false for one that it doesn't meet. */
static inline void bvh_meets(const sure_bvh_node *node, const bvh_probe *probe, double t_max,
                             double enter[SURE_BVH_WIDTH], bool meets[SURE_BVH_WIDTH])
{
    const double *near_x = node->bound[probe->near[0]], *far_x = node->bound[probe->near[0] ^ 1];
    const double *near_y = node->bound[probe->near[1]], *far_y = node->bound[probe->near[1] ^ 1];
    const double *near_z = node->bound[probe->near[2]], *far_z = node->bound[probe->near[2] ^ 1];
    const double *o = probe->o, *to_near = probe->to_near, *to_far = probe->to_far;
    double leave[SURE_BVH_WIDTH];
    BVH_LANES
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        double from = bvh_later((near_x[k] - o[0]) * to_near[0], probe->t_min);
        from = bvh_later((near_y[k] - o[1]) * to_near[1], from);
        enter[k] = bvh_later((near_z[k] - o[2]) * to_near[2], from);
        double to = bvh_earlier((far_x[k] - o[0]) * to_far[0], t_max);
        to = bvh_earlier((far_y[k] - o[1]) * to_far[1], to);
        leave[k] = bvh_earlier((far_z[k] - o[2]) * to_far[2], to) + probe->slack;
    }
    for (int k = 0; k < SURE_BVH_WIDTH; k++)
        meets[k] = enter[k] <= leave[k];
}

#endif
