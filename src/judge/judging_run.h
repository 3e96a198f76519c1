/* A whole judgement: every row is judged and printed as it comes, then the worst cases and the
 * promises. */
#ifndef JUDGE_JUDGING_RUN_H
#define JUDGE_JUDGING_RUN_H

#include "worst.h"

#include <jansson.h>

typedef enum {
    JUDGED,
    JUDGED_BROKEN,    /* a promise is broken */
    JUDGED_UNWRITTEN, /* the JSON file could not be written */
    JUDGED_NOTHING    /* no candidate, cases, answers or truth */
} judging_outcome;

/* Unless the outcome is JUDGED or JUDGED_BROKEN, one line was written to standard error. */
judging_outcome judging_run(const judging_plan *plan, FILE *out);

/* What was found. */
typedef struct {
    judging_row rows[SURE_SHAPES * REGIMES];
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
} judging_findings;

/* The table's head, and a line for each row. */
void judging_print_head(FILE *out, const judging_plan *plan);
void judging_print_row(FILE *out, const judging_row *row);

/* Below the table: breaches and what was not asked; the worst cases; promises, with how many are
 * broken. */
void judging_print_breaches(FILE *out, const judging_findings *of);
void judging_print_worst(FILE *out, const judging_plan *plan, const judging_findings *of);
int judging_print_promises(FILE *out, const promises *all, const judging_findings *of);

/* Everything as one object; NULL when there is no memory. */
json_t *judging_json(const judging_plan *plan, const judging_findings *of);

#endif
