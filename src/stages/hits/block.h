/* SPDX-License-Identifier: MIT */
/* A block of queries, whose first stage is asked several at a time (shapes/lanes). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How many queries at most where a column needs room; how many of them side by side at most, and
 * from how many on; a ray's numbers, and the most that an object has. */
enum { BLOCK = 128, BLOCK_WIDEST = 8, BLOCK_LEAST = 4, RAY_NUMBERS = 8, OBJECT_NUMBERS = 7 };

/* Where the first stage is uncertain, in the place of a status. */
#define BLOCK_UNCERTAIN 0xff

/* Columns of doubles, or floats, at any alignment, of which query i < count is the numbers i;
 * behind less than BLOCK_WIDEST of them others stand, up to so many. one_object: all queries ask
 * the first number of each column of the object, and no other is read. The answers are columns,
 * too, t_error of doubles alone; NULL is not wanted, but for the status, and without a hit all
 * others are written as they are. */
typedef struct {
    const void *ray[RAY_NUMBERS], *object[OBJECT_NUMBERS];
    size_t count;
    bool one_object;
    uint8_t *status, *part, *leaves;
    void *t, *t_error;
} block;

/* The first stage of `certain` for each shape, and a closer look at what that leaves uncertain,
 * NULL where there is none; by the width of what they are compiled for; `_f`: that of certain_f. */
typedef struct {
    void (*first)(const block *b), (*closely)(const block *b);
} block_stage;
#define BLOCK_STAGES(width)                                                                        \
    extern const block_stage block_stages_##width[], block_stages_##width##_f[];
BLOCK_STAGES(2)
BLOCK_STAGES(4)
BLOCK_STAGES(8)

/* How many queries are asked side by side: 2, 4 or 8, as many as this processor can, but at most
 * what the environment variable SUREHIT_LANES said when it was first asked. 1: one by one. */
int block_lanes(void);

/* As if it had said so. A block of a few is answered in the time that it takes to ask it. */
int block_lanes_most(int most);

/* Those for so many; NULL for 1. */
const block_stage *block_stages(void);
const block_stage *block_stages_f(void);
