/* SPDX-License-Identifier: MIT */
/* The answers to many cases of one shape and regime, counted as they come, and what is left of them
 * in the end: the verdict. */
#pragma once

#include "../../cases/regimes/regimes_camera.h"
#include "reply.h"

/* What can be wrong with one answer, held against the right one. */
/* clang-format off */
#define EACH_FAULT(DO) \
    /* the decision, of a valid case */ \
    DO(FALSE_HIT, "false hit") \
    DO(FALSE_MISS, "false miss") \
    DO(WRONG_PART, "wrong part") \
    DO(REFUSED, "valid refused") /* called invalid */ \
    /* the contract */ \
    DO(NOT_A_NUMBER, "not a number")   /* in t or the normal of a hit */ \
    DO(OUT_OF_RANGE, "t out of range") /* t of a hit is outside [t_min, t_max] */ \
    DO(INVALID_ACCEPTED, "invalid accepted") \
    DO(WRONG_FIELD, "wrong field") /* of an invalid case, where it names one */ \
    DO(TOUCHED, "outputs touched") /* on a miss */ \
    DO(CHANGED, "answer changes")  /* on the same input */ \
    DO(LEAKED, "leak") \
    /* no answer: a decision that is not made; in the order of reply_kind */ \
    DO(GARBAGE, "garbage") \
    DO(CRASHED, "crash") \
    DO(HUNG, "no answer in time") \
    DO(LOST, "no answer")
/* clang-format on */

#define FAULT(NAME, name) FAULT_##NAME,
typedef enum { EACH_FAULT(FAULT) FAULTS } fault;
#undef FAULT

#define FAULTS_OF_DECISION FAULT_NOT_A_NUMBER /* so many: the first */
#define FAULTS_ANSWERED FAULT_GARBAGE         /* the first: those of an answer that could be read */

/* "false hit", ... */
const char *fault_name(int which);

/* Has answer and truth the status hit, and the query a t, so that theirs can be compared? */
bool fault_is_hit(const case_answer *truth, const reply *given);

/* The set of them: bit n is fault n. `question` is as the candidate was asked it. */
unsigned faults_of(const sure_case *question, const case_answer *truth, const reply *given);

#define FAULT_BIT(which) (1u << (which))

/* How far a right decision's t and normal are from the true ones. */

/* How many steps from one double (float) to the next lead from x to the one next to the truth,
 * which is known to the nearest double: 0 exactly when x is correctly rounded. Where that double is
 * halfway between two floats, either will do. Infinite for a NaN. -0 is 0, and infinity follows the
 * largest finite number. */
double error_ulps(double x, double truth, precision of);

/* |x - truth| / |truth|: 0 for the same, infinite against a truth of 0. */
double error_relative(double x, double truth);

/* The largest difference of two components. */
double error_normal(sure_vec3 normal, sure_vec3 truth);

/* The same in ulps of its length 1, ... */
double error_normal_ulps(double error, precision of);

/* ... and whether each component is the one next to the truth. */
bool error_normal_none(sure_vec3 normal, sure_vec3 truth, precision of);

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
#define HISTOGRAM_PARTS 32
typedef struct {
    uint64_t count, zeros;
    double most;
    uint64_t binades[HISTOGRAM_BINS / HISTOGRAM_PARTS]; /* what their bins have together */
    uint64_t bins[HISTOGRAM_BINS];
} histogram;

/* A NaN counts as infinite. */
void histogram_add(histogram *all, double size);

/* So many more in a bin. */
void histogram_add_bin(histogram *all, int bin, uint64_t count);

/* The least size, rounded up to a bin's end, that at least that share of the sizes does not exceed;
 * 0 when there are none. */
double histogram_quantile(const histogram *all, double share);

/* Some case, as the candidate was asked it. */
typedef struct {
    bool found;
    sure_case question;
    reply given;
    case_answer truth;
    uint64_t number; /* of cases that are made, in their row */
} example;

/* Of a t that can be compared: how far it is off; of both ends the larger error. */
double example_ulps(const example *one, precision in);

/* Sizes by powers of two: none, up to 1, 2, 4, ... 2^63, more. */
#define SIZE_CLASSES 66

/* Of the errors of all hits that both have. */
typedef struct {
    uint64_t count, right; /* right: correctly rounded */
    double median, q99, q9999, most;
} error_summary;

typedef struct {
    uint64_t cases;       /* asked and answered, or not answered */
    uint64_t valid;       /* of them */
    uint64_t hits;        /* of them */
    uint64_t with_t;      /* hits whose query tells t */
    uint64_t with_normal; /* hits whose query tells the normal */
    uint64_t skipped;     /* not asked: outside of the entry conditions, or invalid in float */
    uint64_t unasked;     /* not asked: the candidate had crashed or hung too often */
    uint64_t faults[FAULTS];
    uint64_t wrong; /* valid cases with a wrong decision or none */
    confidence wrong_share;
    error_summary t_ulps, t_relative, normal_ulps, normal;
    error_summary t_extents, t_pixels; /* of cases with lengths */
    uint64_t t_classes[SIZE_CLASSES];  /* n > 0: ulps above 2^(n - 2), to 2^(n - 1); 0: none */
    example faulty[FAULTS];            /* the first of each */
    example worst_t, worst_normal;
} verdict;

typedef struct {
    verdict sum;
    precision answers_in;
    uint64_t normals_right; /* of t they are the zeros */
    histogram t_ulps, t_relative, normal, t_extents, t_pixels;
} tally;

/* `found`: its faults. Of a case with lengths (by; else NULL) the error of t as a length, too: over
 * the scene's extent, and over what a pixel covers where the true hit is. */
void tally_add(tally *all, const example *one, unsigned found, const camera_lengths *by);

verdict tally_verdict(const tally *all);

/* All of the contract's breaches and missing answers. */
uint64_t verdict_breaches(const verdict *of);
