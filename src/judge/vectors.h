/* Frozen cases with their exact answers, one a line as JSON (docs/vectors.md): for tests in any
 * language. The same bytes on every machine. */
#pragma once

#include "../cases/regimes.h"

#include <jansson.h>

/* Raised when lines are written otherwise; it is the seed of the cases too. */
#define VECTORS_VERSION 1
#define VECTORS_PER_REGIME 40

typedef struct {
    const char *source; /* a regime, or the name of a file of cases, which is cut off if long */
    uint64_t number;    /* the case's index in the regime, or its line in the file */
    sure_case question;
    case_answer answer;
} frozen_case;

/* Case `number` < VECTORS_PER_REGIME of an applicable regime, answered. */
frozen_case vectors_case(sure_shape shape, regime which, uint64_t number);

/* Any other. */
frozen_case vectors_case_of(const char *source, uint64_t number, const sure_case *question);

/* What its line holds, by JSON_COMPACT. */
json_t *vectors_json(const frozen_case *frozen);

/* Writes FOLDER/SHAPE.jsonl: the cases of every regime, then those of these files that are of the
 * shape, one a line; " -> " and what follows, empty lines and lines from # on are passed over.
 * Returns 0 where it is written; else one line went to standard error: 1 where it can't be, 2 where
 * there are no such cases. */
int vectors_write(sure_shape shape, const char *const *files, int count, const char *folder);
