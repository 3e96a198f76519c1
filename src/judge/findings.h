/* What a whole judgement has found, for people (judging_run.c) and for programs. */
#pragma once

#include "conventions.h"

typedef struct {
    identity who;
    uint64_t left_out; /* lines of cases */
    judging_row rows[SURE_SHAPES * JUDGING_ROWS];
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
    bool kept[PROMISES_MOST];
    bool has_said[SURE_SHAPES];
    convention_words said[SURE_SHAPES];
} findings;

/* A worst case, what the candidate said and what is right, as text. */
typedef struct {
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
} worst_lines;
worst_lines worst_lines_of(const worst_case *one);

/* "false hit", ..., "largest error of t" */
const char *worst_name(int kind);

/* A number that is infinite or unknown is null; NULL when there is no memory. */
json_t *findings_json(const judging_plan *plan, const findings *of);
