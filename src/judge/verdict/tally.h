/* The answers to many cases of one shape and regime, counted as they come, and what is left of them
 * in the end: the verdict. */
#ifndef JUDGE_TALLY_H
#define JUDGE_TALLY_H

#include "confidence.h"
#include "error_size.h"
#include "fault.h"
#include "histogram.h"

/* Some case, as the candidate was asked it. */
typedef struct {
    bool found;
    sure_case question;
    reply given;
    case_answer truth;
} example;

/* Sizes by powers of two: none, up to 1, 2, 4, ... 2^63, more. */
#define SIZE_CLASSES 66

/* Of the errors of all hits that both have. */
typedef struct {
    uint64_t count, right; /* right: correctly rounded */
    double median, q99, q9999, most;
} error_summary;

typedef struct {
    uint64_t cases;   /* asked and answered, or not answered */
    uint64_t valid;   /* of them */
    uint64_t hits;    /* of them */
    uint64_t skipped; /* not asked: rounding to float made them invalid */
    uint64_t unasked; /* not asked: the candidate had crashed or hung too often */
    uint64_t faults[FAULTS];
    uint64_t wrong; /* valid cases with a wrong decision or none */
    confidence wrong_share;
    error_summary t_ulps, t_relative, normal_ulps, normal;
    uint64_t t_classes[SIZE_CLASSES]; /* n > 0: ulps above 2^(n - 2), to 2^(n - 1); 0: none */
    example faulty[FAULTS];           /* the first of each */
    example worst_t, worst_normal;
} verdict;

typedef struct {
    verdict sum;
    precision answers_in;
    uint64_t t_right, normals_right;
    histogram t_ulps, t_relative, normal;
} tally;

void tally_clear(tally *all, precision answers_in);
void tally_add(tally *all, const sure_case *question, const case_answer *truth, const reply *given);
verdict tally_verdict(const tally *all);

/* All of the contract's breaches and missing answers. */
uint64_t verdict_breaches(const verdict *of);

#endif
