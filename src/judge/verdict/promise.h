/* SPDX-License-Identifier: MIT */
/* What a candidate was said to keep (`--require decisions,t<=4ulp`), held against a verdict. */
#pragma once

#include "../referee/referee.h"

typedef enum {
    PROMISE_DECISIONS,   /* decisions: none is wrong or missing; decisions<=X: at most that share;
                            decisions@M: none is wrong by more than the margin M */
    PROMISE_CONTRACT,    /* contract: no breach, and every case is answered */
    PROMISE_T_ULPS,      /* t<=Xulp */
    PROMISE_T_RELATIVE,  /* t<=X */
    PROMISE_NORMAL_ULPS, /* normal<=Xulp */
    PROMISE_NORMAL       /* normal<=X */
} promise_kind;

typedef struct {
    promise_kind kind;
    double most;
    double margin; /* of decisions; 0: any */
} promise;

#define PROMISES_MOST 16

typedef struct {
    int count;
    promise list[PROMISES_MOST];
} promises;

/* A list of the above, separated by commas. False: something else. */
bool promises_read(const char *text, promises *all);

/* What a promise of t or normals is held against; NULL: it is of something else. */
const error_summary *promise_errors(const promise *one, const verdict *by);

/* Is it kept? *is: what stands against its `most`; of t and normals infinite where there are hits
 * and none could be compared. */
bool promise_kept(const promise *one, const verdict *by, const refereed *looked_at,
                  const margins *told, double *is);

/* "t<=4ulp" */
void promise_print(const promise *one, char line[CASE_LINE_MAX]);
