/* SPDX-License-Identifier: MIT */
/* Frozen cases with their exact answers, one a line as JSON (docs/vectors.md): for tests in any
 * language. The same bytes on every machine. */
#pragma once

#include "../cases/regimes.h"
#include "../support/progress.h"

#include <jansson.h>

#define VECTORS_VERSION 2    /* raised when lines are written otherwise */
#define VECTORS_SET "2026.2" /* another one when they are others */
#define VECTORS_SEED 1
#define VECTORS_PER_REGIME 40 /* if not told otherwise */

typedef struct {
    const char *source; /* a regime, or the name of a file of cases, which is cut off if long */
    uint64_t number;    /* the case's index in the regime, or its line in the file */
    sure_case question;
    case_answer answer;
} frozen_case;

frozen_case vectors_case_of(const char *source, uint64_t number, const sure_case *question);

/* What its line holds, by JSON_COMPACT and VECTORS_PRECISION. */
#define VECTORS_PRECISION JSON_REAL_PRECISION(1)
json_t *vectors_json(const frozen_case *frozen);

/* Which cases: of these regimes so many each; then those of these files that are of the shape, one
 * a line, where " -> " and what follows, empty lines and lines from # on are passed over. All are
 * made to the entry's; those that can't be so are left out. */
typedef struct {
    regime_rows rows;
    uint64_t count;
    const char *const *files;
    int file_count;
    const char *entry; /* as it was written, "" for none */
    const char *folder;
    progress *bar; /* of cases of regimes; or NULL */
} vectors_plan;

/* Writes FOLDER/SHAPE.jsonl. Returns 0 where it is written; else one line went to standard error: 1
 * where it can't be, 2 where there are no such cases. */
int vectors_write(const vectors_plan *plan, sure_shape shape);
