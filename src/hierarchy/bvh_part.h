/* SPDX-License-Identifier: MIT */
/* The binary tree that a hierarchy is made of. */
#pragma once

#include <surehit/bvh.h>

#include <math.h>

/* Smaller ranges are not worth a task, nor the first of threads. */
#define TASK_LEAST 2048

/* A range that is parted in two, by the index of the place; ends of 0 are leaves. */
typedef struct {
    uint32_t left, right; /* where the halves are parted; 0: a leaf */
} parting;

/* A box by what is least: its lows, and its highs negated; so that one loop does for all. */
typedef struct {
    double least[6];
} extent;

typedef struct {
    const sure_object *objects;
    uint32_t *slots, end;
    extent *boxes;     /* of what is in the slots, but for planes */
    parting *partings; /* by place */
} build;

static const extent empty = {{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY}};

static inline void extend(extent *box, const extent *by)
{
    for (int i = 0; i < 6; i++)
        box->least[i] = by->least[i] < box->least[i] ? by->least[i] : box->least[i];
}

static inline extent box_of(const sure_object *object)
{
    sure_bounds box = {{0}, {0}};
    (void)sure_bvh_box(object, &box);
    return (extent){{box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1], -box.high[2]}};
}

/* Parts a range and what comes of it: where, or 0. Behind `depth` levels in halves. */
uint32_t bvh_part_all(const build *b, uint32_t begin, uint32_t end, int depth);
