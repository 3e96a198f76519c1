/* SPDX-License-Identifier: MIT */
/* Where two pictures differ, and by how much. */
#pragma once

#include "picture.h"

#include <jansson.h>

typedef struct {
    int left, top, width, height; /* pixels; the origin is the picture's upper left corner */
} pixel_box;

typedef struct {
    int sizes[2][2]; /* width and height of either; where they differ, nothing else is compared */
    bool same_size;
    int64_t pixels; /* that differ */
    int largest;    /* difference in a channel */
    pixel_box box;  /* the smallest that holds all pixels that differ */
} difference;

difference difference_of(const picture *a, const picture *b);

/* Same size, same pixels? */
bool difference_is_none(const difference *of);

/* "12 of 57600 pixels, by at most 37, box x=10 y=20 w=5 h=6", or "sizes 320x180 and 160x90". */
void difference_print(FILE *out, const difference *of);

/* The same for programs; NULL when there is no memory. */
json_t *difference_json(const difference *of);

/* Makes *shown (free it with picture_free) from two pictures of one size. What is the same is grey
 * and dim, from `a`; what differs is orange, the brighter the more, and never dim. False when there
 * is no memory. */
bool difference_draw(const picture *a, const picture *b, picture *shown);
