/* SPDX-License-Identifier: MIT */
/* What `surehit render` is asked for, and the two ways to draw it. */
#pragma once

#include "options.h"

#include "../evidence/heat.h"
#include "../photons/forward_sum.h"

#define NO_HEAT HEATS
#define EXIT_INTERRUPTED 130 /* as a shell says of SIGINT; what was done is written */

typedef struct {
    const char *scene;
    cli_list outputs;
    bool quiet, explain, time;
    FILE *words;             /* where they go: not to a picture on standard output */
    const char *certificate; /* its path, or NULL */
    heat_kind heat;          /* NO_HEAT: light */
    render_settings settings;
    int depth; /* where one is given */
    /* of photons from the lights to the eye */
    forward_plan forward; /* bounces 0: the default, which is the falloff's */
    const char *share;    /* where their sums go, or NULL */
} render_request;

/* By the words of the one command that there is. */
extern render_request asked;

/* Both return the exit status. */
int render_backward(const placed_scene *placed);
int render_photons(const placed_scene *placed);
