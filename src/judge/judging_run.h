/* A whole judgement: the parties are opened, every row is judged and printed as it comes, then the
 * worst cases and the promises. */
#ifndef JUDGE_JUDGING_RUN_H
#define JUDGE_JUDGING_RUN_H

#include "judging_report.h"

typedef enum {
    SUBJECT_NONE,
    SUBJECT_TIER,
    SUBJECT_LIBRARY,
    SUBJECT_COMMAND,
    SUBJECT_ANSWERS /* of a file; "-": standard input */
} subject_kind;

/* Of the option "tier", "candidate", "command" or "answers". */
subject_kind judging_kind_named(const char *option);

typedef struct {
    subject_kind subject;
    const char *name;  /* of the candidate */
    sure_tier tier;    /* where it is one */
    const char *cases; /* their file, "-": standard input; NULL: they are made, of */
    regime_rows rows;  /* shapes that are asked for must be answered */
    uint64_t count, seed;
    bool by_reference; /* the truth: surehit-reference; else the tier exact */
    candidate_options how;
    promises required;
    const char *json; /* a path, or NULL */
} judging_plan;

typedef enum {
    JUDGED,
    JUDGED_BROKEN,    /* a promise is broken */
    JUDGED_UNWRITTEN, /* the JSON file could not be written */
    JUDGED_NOTHING    /* no candidate, cases, answers or truth */
} judging_outcome;

/* Unless the outcome is JUDGED or JUDGED_BROKEN, one line was written to standard error. */
judging_outcome judging_run(const judging_plan *plan, FILE *out);

#endif
