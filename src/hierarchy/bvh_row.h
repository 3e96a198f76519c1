/* SPDX-License-Identifier: MIT */
/* Where a node's bounds stand. */
#pragma once

#include <surehit/bvh.h>

/* A row of a node's bounds by its place in bytes, so that no node has an index to multiply. */
static inline size_t bvh_row_at(int row)
{
    return (size_t)row * SURE_BVH_WIDTH * sizeof(double);
}

static inline const double *bvh_row(const sure_bvh_node *node, size_t at)
{
    return (const double *)((const char *)node->bound + at);
}
