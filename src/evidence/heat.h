/* SPDX-License-Identifier: MIT */
/* False colours for what is known of a picture's pixels. */
#pragma once

#include "../tracer/render.h"

typedef enum {
    HEAT_STAGE, /* that decided the hit */
    HEAT_ERROR, /* t_error, in ulps of t */
    HEAT_TIME,  /* that the pixel took */
    HEATS
} heat_kind;

/* "stage", "error", "time"; NULL ends them. */
extern const char *const heat_names[HEATS + 1];

/* Makes *shown (free it with picture_free) of records of that many columns and rows. False when
 * there is no memory. */
bool heat_draw(heat_kind kind, const pixel_record *records, int width, int height, picture *shown);

/* Lines that say what the colours mean. */
void heat_print_key(FILE *out, heat_kind kind, const pixel_record *records, size_t pixels);
