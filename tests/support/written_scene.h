/* SPDX-License-Identifier: MIT */
/* Scenes as texts, and what is said of them. Without Check, for the fuzz target. */
#pragma once

#include "placement.h"
#include "rt.h"

/* Reads back as the same: numbers as hexadecimal floats, every option on a line of its own. To be
 * freed. */
char *written_scene(const rt_scene *scene);

typedef struct {
    bool good;
    rt_scene scene;    /* of a reading, when good */
    sure_scene placed; /* of a placement, when good */
    char *messages;
} outcome;

/* The text is handed over in a block of just its size, so that reading past it shows. */
outcome outcome_of_text(const char *text, size_t size, const char *name, const rt_options *options,
                        rt_options_set set);

outcome outcome_of_file(const char *path, const rt_options *options, rt_options_set set);
outcome outcome_of_placement(const rt_scene *scene);

void outcome_free(outcome *o);
