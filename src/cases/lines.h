/* SPDX-License-Identifier: MIT */
/* Lines of cases, or of answers to them, of a file that may have no end of a line at all. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define CASE_LINES_TEXT 4096 /* with the NUL behind */

typedef struct {
    FILE *in;
    uintmax_t number; /* of the line that was read last */
    size_t length;    /* its characters in the file */
    bool whole;       /* false where `text` is not all of it: a longer one, or one with a NUL */
    char text[CASE_LINES_TEXT];
} case_lines;

/* The next line, without its end. False at the end of the file, and where case_lines_fault says
 * what is wrong. */
bool case_lines_next(case_lines *lines);

/* NULL where the file just ended. */
const char *case_lines_fault(const case_lines *lines);
