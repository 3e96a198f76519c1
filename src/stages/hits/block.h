/* SPDX-License-Identifier: MIT */
/* A block of queries, whose first stage is asked several at a time (shapes/lanes). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How many queries at most, and from how many on; a ray's numbers, and the most that an object
 * has. */
enum { BLOCK = 64, BLOCK_LEAST = 4, RAY_NUMBERS = 8, OBJECT_NUMBERS = 7 };

/* Where the first stage is uncertain, in the place of a status. */
#define BLOCK_UNCERTAIN 0xff

/* Columns of BLOCK doubles, or floats, at any alignment, of which query i < count is the numbers i;
 * where count is less, as many eights of them as it takes. one_object: all queries ask the first
 * number of each column of the object, and no other is read. The answers are columns, too, t_error
 * of doubles alone; but for the status they are written as they are where there is no hit. */
typedef struct {
    const void *ray[RAY_NUMBERS], *object[OBJECT_NUMBERS];
    size_t count;
    bool one_object;
    uint8_t *status, *part, *leaves;
    void *t, *t_error;
} block;

typedef void block_stage(const block *b);

/* The first stage of `certain` for each shape, then that of certain_f, by the width of what they
 * are compiled for. */
#define BLOCK_OF_DOUBLES 0
#define BLOCK_OF_FLOATS SURE_SHAPES
extern block_stage *const block_stages_2[];
extern block_stage *const block_stages_4[];
extern block_stage *const block_stages_8[];

/* How many queries are asked side by side: 2, 4 or 8, as many as this processor can, but at most
 * what the environment variable SUREHIT_LANES says. 0 where they are asked one by one. */
int block_lanes(void);

/* Those for so many; NULL for 0. */
block_stage *const *block_stages(void);
