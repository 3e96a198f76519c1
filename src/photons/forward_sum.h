/* SPDX-License-Identifier: MIT */
/* The sums of a scene's photons: those of a share that is continued, and those that are traced. */
#pragma once

#include "partial_film.h"
#include "render_file.h"

typedef struct {
    const char *scene; /* its path */
    const placed_scene *placed;
    const render_settings *settings; /* photons 0: FORWARD_PHOTONS, or as many as there are */
    sure_forward_options how;
    uint64_t first;   /* photon */
    const char *from; /* the share that is continued, or NULL */
} forward_plan;

#define FORWARD_PHOTONS 10000000

typedef struct {
    partial_film sum;
    uint64_t traced; /* photons */
    bool interrupted;
    scene_times times; /* build and frame */
} forward_sum;

/* Traces photons as to->sum says, on all cores: the same sums whatever their number. A SIGINT ends
 * it, and so does options->is_due, but one is traced at least. Of the options those count that are
 * not about pixels; the bar of progress shows the picture's error so far. False when there is no
 * memory. */
bool forward_sum_trace(const sure_scene *scene, const render_options *options, index_range photons,
                       forward_sum *to);

/* The photons that are wanted. */
index_range forward_sum_range(const forward_plan *plan);

/* Without photons, or with those that are continued; then all others. Free it with
 * partial_film_free(&done->sum), whatever is returned. False after a line to `messages`: no light
 * in the scene, the share can't be continued, or there is no memory. */
bool forward_sum_begin(const forward_plan *plan, FILE *messages, forward_sum *done);
bool forward_sum_fill(const forward_plan *plan, FILE *messages, forward_sum *done);

/* What all photons take, by those that were traced; PHOTONS_UNTIMED for none. */
double forward_sum_seconds(const forward_sum *of);
