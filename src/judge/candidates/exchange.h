/* SPDX-License-Identifier: MIT */
/* What programs are told and tell: cases and answers, as lines or as doubles (docs/coprocess.md).
 */
#pragma once

#include "../verdict/reply.h"

/* Cases once: the second time they go backwards. */
typedef struct {
    const sure_case *cases;
    int count;
    bool again;
    bool intervals; /* are asked, not hits: of lines alone */
} exchange;

/* What a line is allowed to be, with room for some words of the program's own. */
#define MOST_TEXT(lines) ((size_t)(lines)*CASE_LINE_MAX + 65536)

/* The place among the cases of the n-th that is asked. */
int exchange_place(const exchange *of, int n);

/* Each writes to `to` and returns how many bytes. */
size_t exchange_lines(const exchange *of, char *to);
size_t exchange_numbers(const exchange *of, char *to);

/* Of a head and a case, and of an answer, in doubles. */
enum { EXCHANGE_HEAD = 2, EXCHANGE_ANSWER = 6 };

/* The answers to these cases, at *text, which goes on behind them; again: they are compared with
 * the first ones. */
void replies_from_lines(const exchange *of, char **text, reply *replies);
void replies_from_numbers(const exchange *of, const char *text, reply *replies);

/* The last one may have no end. */
int count_lines(const char *text, size_t length);
