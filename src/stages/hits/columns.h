/* SPDX-License-Identifier: MIT */
/* Columns as a block wants them: where they stand, or in its room. */
#pragma once

#include "block.h"

#include "../../numbers/bits.h"

#include <surehit/many.h>

#include <assert.h>
#include <string.h>

/* Columns that don't stand as a block wants them. */
typedef struct {
    double ray[RAY_NUMBERS][BLOCK], object[OBJECT_NUMBERS][BLOCK], t[BLOCK], t_error[BLOCK];
    uint8_t status[BLOCK], part[BLOCK], leaves[BLOCK];
} block_room;

/* Do so many stand in place? Fewer than are asked side by side do not. */
static inline bool is_whole(size_t count)
{
    return count >= BLOCK_WIDEST;
}

/* A column from query `from` on, gathered if it must be. One number for all is gathered once. */
static INLINED const void *column_in(const sure_numbers *column, size_t from, size_t count,
                                     size_t size, void *room)
{
    const ptrdiff_t stride = column->stride;
    const char *at = (const char *)column->first + (ptrdiff_t)from * stride;
    char *to = room;
    assert(column->first);
    if (stride == (ptrdiff_t)size && is_whole(count))
        return at;
    if (stride == 0 && from != 0)
        return room;
    for (size_t i = 0; i < count; i++, at += stride)
        memcpy(to + i * size, at, size);
    for (size_t i = count; !is_whole(i); i++)
        memcpy(to + i * size, to, size);
    return room;
}

/* NULL for a column that nobody wants. */
static void *number_column_in(const sure_number_column *column, size_t from, size_t count,
                              size_t size, void *room, bool wanted)
{
    bool stands = column->first && column->stride == (ptrdiff_t)size && is_whole(count);
    return stands ? (char *)column->first + from * size : column->first || wanted ? room : NULL;
}

static uint8_t *byte_column_in(const sure_byte_column *column, size_t from, size_t count,
                               uint8_t *room, bool wanted)
{
    bool stands = column->first && column->stride == 1 && is_whole(count);
    return stands ? column->first + from : column->first || wanted ? room : NULL;
}

/* What was answered in the room goes to where it is wanted. */
static INLINED void numbers_out(const sure_number_column *column, size_t from, size_t count,
                                size_t size, const void *answers, const uint8_t *status)
{
    char *first = column->first;
    char *to = first ? first + (ptrdiff_t)from * column->stride : NULL;
    if (!to || answers == to)
        return;
    for (size_t i = 0; i < count; i++, to += column->stride) {
        uint64_t answer = 0, number = 0; /* their bytes */
        memcpy(&answer, (const char *)answers + i * size, size);
        memcpy(&number, to, size);
        number = status[i] == SURE_HIT ? answer : number;
        memcpy(to, &number, size);
    }
}

static void bytes_out(const sure_byte_column *column, size_t from, size_t count,
                      const uint8_t *answers, const uint8_t *status)
{
    uint8_t *to = column->first ? column->first + (ptrdiff_t)from * column->stride : NULL;
    if (!to || answers == to)
        return;
    for (size_t i = 0; i < count; i++, to += column->stride)
        *to = !status || status[i] == SURE_HIT ? answers[i] : *to;
}

/* Number i of a column of doubles in a block. */
static inline const void *number_in(const void *column, size_t i)
{
    return (const char *)column + i * sizeof(double);
}
