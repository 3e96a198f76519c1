/* SPDX-License-Identifier: MIT */
/* A bounding volume hierarchy: which of a scene's objects a ray can meet at all. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <surehit/bounds.h>
#include <surehit/object.h>

SURE_C_BEGIN

/* Children of a node. */
#define SURE_BVH_WIDTH 4

/* A node has the boxes of its children, each closed and with all of the child's objects in it. An
 * unused child is a leaf of no slots, its box empty: +infinity to -infinity. */
typedef struct {
    double bound[6][SURE_BVH_WIDTH]; /* low x, high x, low y, high y, low z, high z */
    uint32_t first[SURE_BVH_WIDTH];  /* of a leaf: of its slots; of a node: its index */
    uint8_t count[SURE_BVH_WIDTH];   /* a leaf's slots, or SURE_BVH_INNER */
    uint8_t unused[44];              /* to whole cache lines: 256 bytes */
} sure_bvh_node;

#define SURE_BVH_INNER 255 /* the child is a node */

/* Entry for all who use it: made for these objects; every object is in one slot, a leaf has at most
 * 254. The library makes none: a caller does, of sure_bvh_box, and owns the arrays. One is begun as
 * {0}, for what a later version adds. */
typedef struct {
    const sure_bvh_node *nodes; /* the first one is the root; NULL where no object is bounded */
    const uint32_t *slots;      /* indices of objects, those that are in no box first */
    size_t unbounded;           /* how many of these there are: planes */
    const void *reserved[4];    /* NULL */
} sure_bvh;

/* Nodes on the way from the root to a leaf, at most: what builds a hierarchy keeps to it. */
#define SURE_BVH_DEPTH 64

/* A closed box, its faces across the axes. */
typedef struct {
    double low[3], high[3];
} sure_bounds;

/* A valid object's bounds: 1 and *box; 0 and *box untouched for a shape that is not bounded. */
int sure_bvh_box(const sure_object *object, sure_bounds *box);

SURE_C_END
