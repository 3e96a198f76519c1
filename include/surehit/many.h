/* SPDX-License-Identifier: MIT */
/* Many rays, many objects of a shape, or pairs of both, in one call. */
#pragma once

#include <surehit/object.h>

#include <stddef.h>
#include <stdint.h>

SURE_C_BEGIN

/* Number i of a column is the double that stands i * stride bytes behind `first`, at any alignment.
 * The stride may be negative; 0 means one number for all. */
typedef struct {
    const void *first;
    ptrdiff_t stride;
} sure_numbers;

typedef struct {
    sure_numbers origin[3], direction[3], t_min, t_max;
} sure_rays;

/* A column for each number of the shape's struct, in its order. */
typedef struct {
    sure_shape shape;
    sure_numbers numbers[SURE_SHAPE_NUMBERS];
} sure_objects;

/* The columns of rays, or of a shape's structs, that stand `stride` bytes apart: in an array, or in
 * structs of a user's own. */
sure_rays sure_rays_of(const void *first, ptrdiff_t stride);
sure_objects sure_objects_of(sure_shape shape, const void *first, ptrdiff_t stride);

/* Columns for answers, one number or byte an answer, at any alignment, apart from each other and
 * from what is asked; no stride is 0. A column whose `first` is NULL is not wanted, and its time is
 * not spent. */
typedef struct {
    void *first;
    ptrdiff_t stride;
} sure_number_column;

typedef struct {
    uint8_t *first;
    ptrdiff_t stride;
} sure_byte_column;

typedef struct {
    sure_byte_column status, part, leaves; /* sure_status, sure_part, 0 or 1 */
    sure_number_column t, t_error, normal[3];
} sure_hits;

/* Ray i meets object i?
 *
 * Entry    shape and tier are members; columns of what is asked, and `status`, are not NULL;
 *          columns that are wanted have room for `count`. Count 0 writes nothing.
 * Returns  in the columns what sure_object_hit and sure_object_normal answer for each ray and its
 *          object; on miss and invalid the status alone, the other columns' numbers untouched.
 * Bound    sure_object_hit's.
 * Source   the shape's header.
 * Proof    the shape's header.
 *
 * Law 1: every answer is the call's for that ray alone, bit by bit. */
void sure_objects_hits(size_t count, const sure_rays *rays, const sure_objects *objects,
                       sure_tier tier, const sure_hits *hits);

/* Does ray i meet object i? In bits: that of ray i is i % 8 of byte i / 8, counted from the lowest.
 *
 * Entry    shape and tier are members; `mask` has room for `count` bits, in whole bytes.
 * Returns  how many queries are invalid. The bit of a ray is 1 where sure_objects_hits answers
 *          SURE_HIT, else 0; bits of the last byte that are nobody's are 0.
 * Bound    sure_object_hit's.
 * Source   the shape's header.
 * Proof    the shape's header.
 *
 * Law 1: every bit is the status of the call for that ray alone. */
size_t sure_objects_occluded(size_t count, const sure_rays *rays, const sure_objects *objects,
                             sure_tier tier, uint8_t *mask);

/* sure_<shape>_hits_<tier>: the same as sure_objects_hits for one object. */
#define SURE_MANY_TIER(shape, tier)                                                                \
    void sure_##shape##_hits_##tier(size_t count, const sure_rays *rays,                           \
                                    const sure_##shape *shape, const sure_hits *hits);
#define SURE_MANY(shape, SHAPE)                                                                    \
    SURE_MANY_TIER(shape, float32)                                                                 \
    SURE_MANY_TIER(shape, textbook)                                                                \
    SURE_MANY_TIER(shape, stable)                                                                  \
    SURE_MANY_TIER(shape, certain)                                                                 \
    SURE_MANY_TIER(shape, exact)
SURE_EACH_SHAPE(SURE_MANY)

SURE_C_END
