/* SPDX-License-Identifier: MIT */
/* How long an answer takes: every tier beside the naive peer (reference/peers), on the same cases,
 * in turns. One thread; the naive peer is asked one ray at a time. In floats certain_f and exact_f
 * are beside the naive peer in single precision and the peer textbook_float. */
#pragma once

#include "../../cases/regimes.h"
#include "../../numbers/bits.h"

#include <jansson.h>

/* The subjects: the naive peer, then the tiers, and one more. */
#define BENCH_NAIVE 0
#define BENCH_TIER(tier) (1 + (int)(tier))
/* The naive peer for many rays a call: where the tiers are asked so. */
#define BENCH_NAIVE_BLOCK (1 + SURE_TIERS)
#define BENCH_SUBJECTS (2 + SURE_TIERS)

/* "naive", "naive block" or the tier's name. */
const char *bench_subject_name(int subject);

/* Which of a regime's cases: as they come; or those that hit, or those that miss, which a branch
 * predictor foresees; or as they come, but always in one order, which it learns when they are few.
 */
typedef enum { BENCH_MIXED, BENCH_HITS, BENCH_MISSES, BENCH_REPEATED, BENCH_RAYS } bench_rays;

/* "mixed", ..., NULL at the end. */
extern const char *const bench_rays_names[];

typedef struct {
    int cases;         /* different ones, asked in another order every time but where repeated */
    int repeats;       /* of all of them; a row ends sooner, ... */
    double seconds;    /* ... but not before three, when it has taken this long */
    bool instructions; /* are told, too (instructions.h) */
    unsigned only;     /* bits of the subjects to be asked beside naive and textbook; 0: all are */
    bool floats;       /* cases are rounded to floats, and asked so (surehit/floats.h) */
    int block;    /* so many rays a call before one object (surehit/many.h); 0: each by itself */
    bool objects; /* of these calls: one ray before so many objects */
} bench_plan;

#define BENCH_CASES 16384
#define BENCH_CASES_MOST 1048576
#define BENCH_REPEATS 31
#define BENCH_REPEATS_MOST 10000
#define BENCH_SECONDS 6.0
#define BENCH_BLOCK_MOST 4096

/* Does the plan have it at all? In floats there are the peers, certain and exact, in blocks naive
 * and certain alone; the naive block is of doubles, before one object. */
bool bench_has(const bench_plan *plan, int subject);

/* Is the subject shown? The textbook may be asked for the others' sake alone. */
bool bench_shows(const bench_plan *plan, int subject);

/* The median over the repeats that count and their quartiles, which say how noisy it is. */
typedef struct {
    double median, lower, upper;
} bench_figure;

/* Of that many values, which are sorted then. */
bench_figure bench_figure_of(double *values, int count);

typedef struct {
    bool asked;
    bench_figure nanoseconds;   /* a ray */
    bench_figure over_naive;    /* how many times the naive peer's time, repeat by repeat */
    bench_figure over_textbook; /* the same of the textbook, ... */
    bench_figure over_faster;   /* ... and of the faster of these two in this row */
    bench_figure over_block;    /* of the naive block; NaN where it is not asked */
    double instructions;        /* a ray of the first cases; -1: not counted */
    uint64_t hits;              /* among the cases */
    uint64_t checksum;          /* the sum of bench_checksum over the cases */
} bench_result;

typedef struct {
    sure_shape shape;
    regime which;
    bench_rays rays;
    int cases, repeats; /* repeats that were made */
    double quiet;       /* the share of them that counts: nothing else slowed the core down */
    bench_result results[BENCH_SUBJECTS];
} bench_row;

/* Measures a regime that applies to the shape. Of hits or misses there may be fewer than the plan
 * wants, or none: a row of 0 cases. False: no memory. */
bool bench_measure(const bench_plan *plan, sure_shape shape, regime which, bench_rays rays,
                   bench_row *row);

/* An answer as the sums above count it: t on a hit, and the status. No branch here depends on the
 * answer: the routine's own are to be measured. */
static inline uint64_t bench_t_sum(sure_status status, double t)
{
    return bits_of(t) & (0 - (uint64_t)(status == SURE_HIT));
}

static inline uint64_t bench_checksum(sure_status status, double t)
{
    return bench_t_sum(status, t) + (uint64_t)status;
}

/* The processor's own name, or "unknown"; valid until the next call. */
const char *bench_cpu_name(void);

/* The compiler of this file, as it names itself. */
const char *bench_compiler_name(void);

/* The table's head, and a row's lines: the plan's subjects and the naive peer. */
void bench_print_head(const bench_plan *plan, const char *flags);
void bench_print_row(const bench_plan *plan, const bench_row *row);

/* One object with every figure of every row; NULL when there is no memory. */
json_t *bench_json(const bench_plan *plan, const char *flags, const bench_row *rows, int count);

/* Was the processor's core all ours? What runs on its other half makes code that keeps every unit
 * busy up to twice as slow, and code that waits for its own results hardly: no ratio of such times
 * means anything then, and no clock tells. A fixed calculation does: this is how many times the
 * least time that it ever took it takes now. A few microseconds; for one thread. */
double noise_probe(void);

/* Noise that counts as none. Measured on a shared machine: 1.00 to 1.07, or 1.34 to 2. */
#define NOISE_MOST 1.1

/* How many of these, in ascending order, count as none: as above, or the first `enough` of them, or
 * all. */
int noise_quiet(const double *noise, int count, int enough);
