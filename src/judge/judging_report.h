/* What the judge found, for people and for programs. */
#ifndef JUDGE_JUDGING_REPORT_H
#define JUDGE_JUDGING_REPORT_H

#include "verdict/promise.h"
#include "worst.h"

#include <jansson.h>
#include <stdio.h>

typedef struct {
    const char *candidate; /* "certain", "./mine.so", ... */
    const char *option;    /* how it was named: "--tier certain"; NULL: it can't be asked again */
    const char *truth;     /* "exact", "reference" */
    bool is_tier;
    bool by_like;         /* certain or exact, held against exact: no independent evidence */
    bool counts_text;     /* its time is that of reading and writing lines too */
    uint64_t seed, count; /* of each regime; 0: the cases were given */
} judging_subject;

/* The table's head, and a line for each row. */
void judging_print_head(FILE *out, const judging_subject *subject);
void judging_print_row(FILE *out, const judging_row *row);

/* Below the table: breaches, what was not asked, the worst cases, promises. */
void judging_print_breaches(FILE *out, const judging_row *rows, int count);
void judging_print_worst(FILE *out, const judging_subject *subject, const worst_case *list,
                         int count);

/* Which promises are broken, and where: how many. */
int judging_print_promises(FILE *out, const promises *all, const judging_row *rows, int count);

/* Everything as one object; NULL when there is no memory. */
json_t *judging_json(const judging_subject *subject, const judging_row *rows, int row_count,
                     const worst_case *list, int list_count, const promises *all);

#endif
