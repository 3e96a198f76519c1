/* SPDX-License-Identifier: MIT */
/* What went wrong, in words. */
#pragma once

#include "../judging.h"

/* A case, what the candidate said and what is right, as text. */
typedef struct {
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
} example_lines;
example_lines example_lines_of(const example *one);

/* "false hit", ..., "largest error of t" */
const char *worst_name(int kind);

/* Of a wrong decision, what happens in its case (event.h); else NULL. */
const char *worst_event(const worst_case *one);
