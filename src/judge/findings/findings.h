/* SPDX-License-Identifier: MIT */
/* What a whole judgement has found: for people (table.c), for programs (findings.c), for what
 * runs tests (junit.c) and for what shows results (sarif.c). */
#pragma once

#include "../conventions.h"
#include "examples.h"

#include <jansson.h>

typedef struct {
    identity who;
    uint64_t left_out; /* lines of cases */
    judging_row rows[JUDGING_ALL_ROWS];
    int width; /* of the shapes and queries, in print */
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
    bool kept[PROMISES_MOST];
    bool has_said[SURE_SHAPES];
    convention_words said[SURE_SHAPES];
} findings;

/* A promise held against a row. */
typedef struct {
    const judging_row *row;
    char promised[CASE_LINE_MAX];
    bool kept;
    bool none;            /* there was nothing to hold it against */
    double is;            /* what stands against it */
    const example *shown; /* a case that breaks it, or NULL */
} promised_row;

/* All of them by number, promise by promise. False: there is no such number. */
bool findings_promised(const judging_plan *plan, const findings *of, int number, promised_row *one);

/* Tables, in this order; a row as it comes. The last one tells which promises are kept, and how
 * many are broken. */
void findings_print_head(const judging_plan *plan, const findings *of);
void findings_print_row(const judging_row *row, int width);
void findings_print_lengths(const findings *of);
void findings_print_margins(const judging_plan *plan, const candidate *asked, const findings *of);
void findings_print_conventions(const findings *of);
void findings_print_breaches(const findings *of);
void findings_print_skipped(const findings *of);
void findings_print_worst(const judging_plan *plan, const findings *of);
int findings_print_promises(const judging_plan *plan, findings *of);

/* A number that is infinite or unknown is null; NULL when there is no memory. */
json_t *judging_errors(const error_summary *of);
json_t *judging_time(double time);
json_t *findings_json(const judging_plan *plan, const findings *of);
json_t *worst_json(const worst_case *one);
json_t *identity_json(const identity *who); /* null for what it doesn't say */

/* SARIF 2.1.0: a result is a breach of the contract in a row, or a promise that it breaks. */
json_t *sarif_json(const judging_plan *plan, const findings *of);

/* True for no path, too. On false one line was written to `messages`. */
bool junit_write(const judging_plan *plan, const findings *of, const char *path, FILE *messages);
