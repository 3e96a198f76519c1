/* SPDX-License-Identifier: MIT */
/* Does a ray meet boxes? Never no where it does: docs/proofs/bvh.md counts the roundings, in
 * any mode, subnormals flushed or not. More often than it does yes costs time alone. */
#pragma once

#include "bvh_axis.h"
#include "bvh_row.h"

#include <surehit/ray.h>

/* A ray as boxes are asked about it. */
typedef struct {
    double o[3], to_near[3], to_far[3]; /* 1/d, less and more */
    size_t near[3], far[3];             /* bvh_row's */
    double t_min;
    double slack; /* of t, for what is flushed */
} bvh_probe;

static INLINED bvh_probe bvh_probe_of(const sure_ray *ray)
{
    const double o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    bvh_probe probe; /* nothing is set twice: that takes time here */
    probe.t_min = ray->t_min;
    probe.slack = WALK_FLUSHED;
    for (int i = 0; i < 3; i++) {
        const bvh_axis axis = bvh_axis_of(o[i], d[i]);
        probe.o[i] = axis.o;
        probe.near[i] = bvh_row_at(2 * i + axis.down);
        probe.far[i] = bvh_row_at(2 * i + !axis.down);
        probe.to_near[i] = axis.to_near;
        probe.to_far[i] = axis.to_far;
        probe.slack = bvh_later(axis.slack, probe.slack);
    }
    return probe;
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
#else
#define BVH_WIDE
#endif

/* Where the ray meets the children's boxes, up to t_max; 0 for one that it doesn't meet, else all
 * ones. */
static INLINED void bvh_meets(const sure_bvh_node *node, const bvh_probe *probe, double t_max,
                              double enter[SURE_BVH_WIDTH], uint64_t meets[SURE_BVH_WIDTH])
{
    const double *near_x = bvh_row(node, probe->near[0]), *far_x = bvh_row(node, probe->far[0]);
    const double *near_y = bvh_row(node, probe->near[1]), *far_y = bvh_row(node, probe->far[1]);
    const double *near_z = bvh_row(node, probe->near[2]), *far_z = bvh_row(node, probe->far[2]);
    const double *o = probe->o, *to_near = probe->to_near, *to_far = probe->to_far;
    BVH_LANES
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        double from = bvh_later(bvh_at(near_x[k], o[0], to_near[0]), probe->t_min);
        from = bvh_later(bvh_at(near_y[k], o[1], to_near[1]), from);
        enter[k] = bvh_later(bvh_at(near_z[k], o[2], to_near[2]), from);
        double to = bvh_earlier(bvh_at(far_x[k], o[0], to_far[0]), t_max);
        to = bvh_earlier(bvh_at(far_y[k], o[1], to_far[1]), to);
        double leave = bvh_earlier(bvh_at(far_z[k], o[2], to_far[2]), to) + probe->slack;
        meets[k] = enter[k] <= leave ? UINT64_MAX : 0;
    }
}
