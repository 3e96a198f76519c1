/* A whole judgement: every row is judged and printed as it comes, then the worst cases and the
 * promises. */
#ifndef JUDGE_JUDGING_RUN_H
#define JUDGE_JUDGING_RUN_H

#include "judging.h"

#include <jansson.h>

/* The cases to look at: of every kind of fault, and of the largest errors, one, made simple. */

/* The faults, then these. */
#define WORST_T FAULTS
#define WORST_NORMAL (FAULTS + 1)
#define WORST_KINDS (FAULTS + 2)

const char *worst_name(int kind);

typedef struct {
    int kind;
    sure_shape shape;
    int which; /* the regime where it was met, or JUDGING_GIVEN */
    precision in;
    example found; /* made simple where the candidate still does it then */
} worst_case;

/* The case, what the candidate said and what is right, as text. */
typedef struct {
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
} worst_lines;
worst_lines worst_lines_of(const worst_case *one);

/* Up to one of each kind, in their order; how many. */
int worst_find(judging *self, const judging_row *rows, int count, worst_case list[WORST_KINDS]);

/* In ulps: of t for WORST_T, of the normal for WORST_NORMAL. */
double worst_size(int kind, const example *one, precision in);

/* Returns 0; 1 where a promise is broken or the JSON file could not be written; 2 where there is no
 * candidate, cases, answers or truth. Of the last two one line was written to standard error. */
int judging_run(const judging_plan *plan);

/* What was found. */
typedef struct {
    judging_row rows[SURE_SHAPES * REGIMES];
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
} judging_findings;

/* Everything as one object; NULL when there is no memory. */
json_t *judging_json(const judging_plan *plan, const judging_findings *of);

#endif
