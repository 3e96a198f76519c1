/* The cases to look at: of every kind of fault, and of the largest errors, one, made simple. */
#ifndef JUDGE_WORST_H
#define JUDGE_WORST_H

#include "judging.h"

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

#endif
