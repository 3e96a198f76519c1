/* SPDX-License-Identifier: MIT */
/* What may not change of the answers to one case, column by column (docs/frozen.md). */
#pragma once

#include "regimes.h"

#include <stdint.h>
#include <stdio.h>

typedef enum {
    COLUMN_CASE,     /* the case's own numbers: what the generators make */
    COLUMN_CERTAIN,  /* certain, all that is decided and no t */
    COLUMN_EXACT,    /* exact, the hit */
    COLUMN_NORMAL,   /* exact */
    COLUMN_INTERVAL, /* exact */
    COLUMN_OCCLUDED, /* exact */
    COLUMN_ORDER,    /* of hits of certain, and of exact where that is another */
    COLUMN_SPAWN,    /* on which sides sure_spawn finds a point */
    COLUMN_ORIGIN    /* the points that it finds */
} column;

#define COLUMNS 9

const char *column_name(column which);

/* Where answers go: into the digests, and into a file as text unless that is NULL. */
typedef struct {
    FILE *text;
    uint64_t digests[COLUMNS]; /* FNV-1a */
    uint64_t counts[COLUMNS];  /* of answers */
} frozen_answers;

frozen_answers answers_none(FILE *text);

#define ANSWERS_SEED 1

/* Asks all about case `index` of the regime, of ANSWERS_SEED. */
void answers_add(frozen_answers *sum, sure_shape shape, regime which, uint64_t index);
