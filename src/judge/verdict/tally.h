/* The answers to many cases of one shape and regime, counted as they come, and what is left of them
 * in the end: the verdict. */
#ifndef JUDGE_TALLY_H
#define JUDGE_TALLY_H

#include "error_size.h"
#include "fault.h"

/* How sure a share is that was counted: Wilson's score interval. Of all such cases, between these
 * shares of them are counted, in 95 of 100 such samples. It holds for few and for none: 0 of n is
 * up to 3.84 / (n + 3.84). Without a sample nothing is known: 0 to 1. */
typedef struct {
    double lower, upper;
} confidence;
confidence confidence_of(uint64_t counted, uint64_t sample);

/* Errors counted by size, so that any share of them can be asked for afterwards. A size >= 0 falls
 * into one of 32 equal parts of its binade: whole numbers to 64 are told apart, larger sizes to one
 * part in 32, upwards. The largest is kept as it is. */
#define HISTOGRAM_BINS 65536 /* the upper 16 bits of a double >= 0, infinity included */
typedef struct {
    uint64_t count, zeros;
    double most;
    uint32_t bins[HISTOGRAM_BINS];
} histogram;

/* A NaN counts as infinite. */
void histogram_add(histogram *all, double size);

/* The least size, rounded up to a bin's end, that at least that share of the sizes does not exceed;
 * 0 when there are none. */
double histogram_quantile(const histogram *all, double share);

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
    uint64_t normals_right; /* of t they are the zeros */
    histogram t_ulps, t_relative, normal;
} tally;

void tally_clear(tally *all, precision answers_in);
void tally_add(tally *all, const sure_case *question, const case_answer *truth, const reply *given);
verdict tally_verdict(const tally *all);

/* All of the contract's breaches and missing answers. */
uint64_t verdict_breaches(const verdict *of);

#endif
