/* SPDX-License-Identifier: MIT */
/* A bar with the time left, for those who wait more than a second. Where the output is no terminal,
 * a line every ten seconds. A NULL bar is nobody's: nothing happens. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define PROGRESS_NOTE 24 /* bytes of a note, its end among them */

typedef struct {
    FILE *out;
    bool is_terminal;
    int64_t done, total;
    double started, drawn;    /* seconds */
    int width;                /* of what is to be erased; 0 before anything was drawn */
    char note[PROGRESS_NOTE]; /* stands behind the time left */
} progress;

/* Seconds since some moment, never running backwards. */
double progress_clock(void);

/* Nothing is drawn before a second has passed, and on NULL. A total of 0 is not known: what is done
 * is counted, and no time told. */
progress progress_start(FILE *out, int64_t total);

/* So many times that much; 0, which is not known, where it is more than anybody waits for. */
int64_t progress_total(int64_t times, uint64_t much);

/* `steps` more of the total are done. Not for two threads at once. */
void progress_step(progress *bar, int64_t steps);

/* Will the next step draw? */
bool progress_is_due(const progress *bar);

/* Erases the bar, until the next step that draws: before other output, and at the end. */
void progress_finish(progress *bar);
