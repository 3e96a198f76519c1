/* SPDX-License-Identifier: MIT */
/* The named generators of hard cases (docs/regimes.md). Case i of a regime is a pure function of
 * (shape, regime, seed, i), the same on every machine: integers, + - * / sqrt, rounded to nearest,
 * and scaling by powers of two. */
#pragma once

#include "case.h"
#include "sets.h"

#define REGIME(NAME, name, key, of) REGIME_##NAME,
typedef enum {
#include "regimes.def"
    REGIMES
} regime;
#undef REGIME

/* "typical", "on_surface", ...; NULL for a number that is no regime. */
const char *regime_name(regime which);

/* Finds the regime of that name: 1 and *which written, or 0 and *which untouched. */
int regime_from_name(const char *name, regime *which);

/* The regime that a case line names in its remark: likewise. */
int regime_remarked(const char *line, regime *which);

/* Does the regime mean anything for the shape (apex: cone only, ...)? */
int regime_applies(sure_shape shape, regime which);

/* Shapes and regimes that were asked for; none is all. */
typedef struct {
    bool shapes[SURE_SHAPES], regimes[REGIMES];
    bool some_shapes, some_regimes;
    const case_set *set; /* no others than its; NULL: any */
} regime_rows;

/* Is the pair asked for, and does the regime mean anything for the shape? */
bool regime_rows_have(const regime_rows *asked, int shape, int which);

/* The random numbers of case `index` of an applicable regime; and the case. */
rng regime_rng(sure_shape shape, regime which, uint64_t seed, uint64_t index);
sure_case regime_case(sure_shape shape, regime which, uint64_t seed, uint64_t index);

/* How many different cases REGIME_INTEGERS has for the shape: so many successive indices give each
 * of them once. */
uint64_t regime_integers_count(sure_shape shape);
