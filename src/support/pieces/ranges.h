/* SPDX-License-Identifier: MIT */
/* Which of many numbered pieces are done: ranges of their numbers. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Numbers lie below this, and so does any JSON integer that has one. */
#define RANGES_MOST (UINT64_C(1) << 56)

/* Numbers first .. end - 1. */
typedef struct {
    uint64_t first, end;
} index_range;

/* In order, apart from one another; all.of is freed by free(). */
typedef struct {
    index_range *of;
    size_t count;
} index_ranges;

/* Of a range that is not empty and has no number in common with them. False when there is no
 * memory, and nothing has changed. */
bool ranges_add(index_ranges *all, index_range more);

/* Numbers that are in both: the first such range. */
bool ranges_overlap(const index_ranges *a, const index_ranges *b, index_range *both);

/* The first numbers of a range that are missing; false: none is. */
bool ranges_gap(const index_ranges *all, index_range wanted, index_range *gap);

/* How many numbers they have. */
uint64_t ranges_total(const index_ranges *all);

/* As JSON: of each range the first number, and how many. */
json_t *ranges_json(const index_ranges *all);

/* Reads them, at least one, into *all, which has none and is freed whatever is returned. Returns
 * what is wrong, or NULL. */
const char *ranges_take(const json_t *list, index_ranges *all);
