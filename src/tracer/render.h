/* SPDX-License-Identifier: MIT */
/* All pixels of a scene, on all cores, the same bytes whatever their number. */
#pragma once

#include "../image/picture.h"

#include <surehit/statistics.h>
#include <surehit/scene.h>

/* What is known of a pixel's own ray. */
typedef struct {
    double t, t_error;  /* of the hit */
    float microseconds; /* that the pixel took, all of its rays */
    uint32_t object;
    uint8_t seen, part, stage; /* sure_status; sure_part and sure_stage of a hit */
} pixel_record;

/* A part of the picture, from the upper left corner. */
typedef struct {
    int x, y, width, height;
} picture_part;

typedef struct {
    sure_tier tier;
    int threads;       /* 0: one a core */
    int samples;       /* a side: each pixel is the mean of their square; 0: one */
    picture_part part; /* width 0: all of it */
    bool progress;     /* a bar with the time left on standard error, from the first second on */
    bool without_bvh;  /* every ray asks every object: slower, of certain and exact the same */
    sure_statistics *statistics; /* is added to, or NULL; ... */
    pixel_record *records;       /* ... one a pixel of the part, or NULL. Either makes it slower */
    bool clocked; /* records get the time alone, of pixels that are drawn as if nobody asked */
    int64_t first_square, end_square; /* of the part, which is drawn in squares; end 0: all */
    bool (*goes_on)(uint64_t end); /* asked when all before `end` are drawn; NULL: till the end */
    bool (*is_due)(void);          /* asked between photons: true ends it; NULL: never */
} render_options;

/* How many threads these options mean here. */
int render_threads(const render_options *how);

/* Reads "X,Y,WxH": digits, and neither W nor H is 0. False: *part is untouched. */
bool render_part_from(const char *text, picture_part *part);

/* Does the part lie within a picture of that size? */
bool render_part_fits(const picture_part *part, int width, int height);

/* How many squares a picture of that size is drawn in, by reading order, and where one is. */
int64_t render_squares(int width, int height);
picture_part render_square(int width, int height, int64_t number);

/* The size of the picture that the options ask for. False where the part is not within the scene's
 * picture, or there are too many samples to count their columns or rows. */
bool render_size(const sure_scene *scene, const render_options *options, int *width, int *height);

/* Fills *image, or squares of it (allocated by picture_new, of render_size). Linear colours are
 * clamped to 0..1, times 255, rounded to nearest. */
void render(const sure_scene *scene, const render_options *options, picture *image);
