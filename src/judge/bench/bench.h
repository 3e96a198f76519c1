/* How long an answer takes: every tier beside the naive peer (reference/peers), on the same cases,
 * in turns. One ray at a time, one thread. */
#ifndef JUDGE_BENCH_H
#define JUDGE_BENCH_H

#include "../../cases/regimes.h"

#include <stdbool.h>
#include <stdint.h>

/* The subjects: the naive peer, then the tiers. */
#define BENCH_NAIVE 0
#define BENCH_TIER(tier) (1 + (int)(tier))
#define BENCH_SUBJECTS (1 + SURE_TIERS)

/* "naive" or the tier's name. */
const char *bench_subject_name(int subject);

typedef struct {
    int cases;                     /* different ones, asked in another order every time */
    int repeats;                   /* of all of them; a row ends sooner, ... */
    double seconds;                /* ... but not before three, when it has taken this long */
    bool subjects[BENCH_SUBJECTS]; /* whom to ask; naive and textbook are asked anyway */
} bench_plan;

#define BENCH_CASES 16384
#define BENCH_CASES_MOST 1048576
#define BENCH_REPEATS 31
#define BENCH_REPEATS_MOST 10000
#define BENCH_SECONDS 6.0

/* All subjects, and the usual numbers above. */
bench_plan bench_usual_plan(void);

/* The median over the repeats that count and their quartiles, which say how noisy it is. */
typedef struct {
    double median, lower, upper;
} bench_figure;

typedef struct {
    bool asked;
    bench_figure nanoseconds;   /* a ray */
    bench_figure over_naive;    /* how many times the naive peer's time, repeat by repeat */
    bench_figure over_textbook; /* the same of the textbook */
    uint64_t hits;              /* among the cases */
    uint64_t checksum;          /* the sum of bench_checksum over the cases */
} bench_result;

typedef struct {
    sure_shape shape;
    regime which;
    int cases, repeats; /* repeats that were made */
    double quiet;       /* the share of them that counts: nothing else slowed the core down */
    bench_result results[BENCH_SUBJECTS];
} bench_row;

/* Measures a regime that applies to the shape. False: no memory. */
bool bench_measure(const bench_plan *plan, sure_shape shape, regime which, bench_row *row);

/* An answer as the sums above count it: t on a hit, and the status. */
uint64_t bench_checksum(sure_status status, double t);

#endif
