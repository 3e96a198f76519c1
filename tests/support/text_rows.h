/* SPDX-License-Identifier: MIT */
/* Files of rows: a text, and behind it lines that are indented by four blanks. Those that begin
 * with // are comments. In the text \n, \r, \t, \\ and \x of two digits are what they are in C. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { ROW_BYTES = 600, ROW_LINES_BYTES = 4 * ROW_BYTES };

typedef struct {
    char text[ROW_BYTES];
    size_t size; /* of the text, which may hold 0 */
    char lines[ROW_LINES_BYTES];
} text_row;

/* Of a name in the tests' folder; fails the running test where it can't be read. */
FILE *rows_open(const char *name);

/* The next text and, without their indent, the lines behind it; false at the end. */
bool rows_next(FILE *file, text_row *row);

/* Takes the lines out of the text that are also in `known`. */
void rows_drop_known(char *text, const char *known);

/* Of files whose rows are lines: the next that is neither empty nor begins with #; false at the
 * end. */
bool rows_line(FILE *file, char *line, size_t size);

/* What is behind the mark, which is cut off; fails the running test where there is none. */
char *row_cut(char *text, const char *mark);
