/* SPDX-License-Identifier: MIT */
/* A command that works in pieces (cut.h), and the words that it was planned with. */
#pragma once

#include "../options.h"

#include <jansson.h>

/* What is asked by these words, of this program. Takes the array over; NULL: no memory. */
json_t *words_asked(json_t *words);

/* Runs the command, with an option more for each name that has a value; a NULL name ends them,
 * MORE_WORDS_MOST at most. Returns its exit status. */
#define MORE_WORDS_MOST 3
typedef struct {
    const char *name, *value; /* "--share", "a.share"; a NULL value: not given; "": it has none */
} more_words;
int words_run(const json_t *asked, const more_words *more);

/* The command, or NULL after a complaint: it can't be cut. */
const cli_command *words_command(const json_t *asked);
