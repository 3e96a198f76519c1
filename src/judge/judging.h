/* A candidate held against the truth: over the cases of a regime, or over given ones. */
#ifndef JUDGE_JUDGING_H
#define JUDGE_JUDGING_H

#include "../cases/regimes.h"
#include "verdict/tally.h"
#include "truth.h"

#include <stdio.h>

#define JUDGING_GIVEN REGIMES /* in a regime's place: the cases were given */

/* Nanoseconds a ray, all three asked the same cases one after the other, with normals where the
 * candidate gives them (a tier: hits alone); 0 where not known. */
typedef struct {
    double candidate, textbook, certain;
} judging_times;

typedef struct {
    sure_shape shape;
    int which; /* a regime, or JUDGING_GIVEN */
    verdict sum;
    judging_times times;
} judging_row;

/* "typical", ..., "given" */
const char *judging_row_name(const judging_row *row);

typedef struct judging judging;

/* The answers come from the candidate, or, where it is NULL, from the lines of `answers`, which is
 * then named for messages; `in` is their precision. NULL: no memory. */
typedef struct {
    candidate *asked;
    truth known;
    FILE *answers;
    const char *answers_name;
    precision in;
    bool untimed; /* no times are taken */
} judging_parties;

judging *judging_new(const judging_parties *parties);
void judging_free(judging *self);

/* Judges the first `count` cases of a regime that applies to the shape. False after a message. */
bool judging_regime(judging *self, sure_shape shape, regime which, uint64_t seed, uint64_t count,
                    judging_row *row, char *message);

/* Judges the case lines of a file, a row for each shape that occurs. */
bool judging_given(judging *self, FILE *cases, const char *name, judging_row rows[SURE_SHAPES],
                   int *count, char *message);

/* True unless there are more answers than cases. */
bool judging_answers_end(const judging *self, char *message);

/* What the candidate says to up to JUDGING_SEVERAL cases of one shape, and the truth; not found: it
 * is no case for a candidate in float. False: the truth is not told, or the candidate can't be
 * asked. */
#define JUDGING_SEVERAL 2048
bool judging_several(judging *self, const sure_case *questions, int count, example *answered);

/* What the shape is answered in. */
precision judging_precision(const judging *self, sure_shape shape);

/* Are candidate and truth at hand for a single case? Else a program is started each time, and had
 * better be asked several at once. */
bool judging_is_quick(const judging *self);

#endif
