/* SPDX-License-Identifier: MIT */
/* Computing in every environment, over every regime, and uphill; and what is said of a case that
 * fails. */
#pragma once

#include "regimes.h"
#include "suite.h"
#include "test_shape.h"

/* Fails with `what`, the environment last computed in and the case, unless it holds. */
void case_require(const sure_case *c, bool holds, const char *what);

bool case_is_valid(const sure_case *c);

/* |truth - value| / error; 0 where both are equal. */
double share_of_error(mpfr_t truth, double value, double error);
double share_of_pair(mpfr_t truth, double head, double tail, double error);

/* Numbers of surroundings.h: four rounding modes, and to nearest with subnormals flushed. */
enum { ENVIRONMENTS = 5 };

/* Cases 0 to count - 1 of each regime that applies to the shape:
 *
 *     for (case_walk w = walk_regimes(shape, seed, count); walk_next(&w);) */
typedef struct {
    sure_shape shape;
    uint64_t seed, count, index;
    regime which;
    sure_case asked;
} case_walk;
case_walk walk_regimes(sure_shape shape, uint64_t seed, uint64_t count);
bool walk_next(case_walk *w);

typedef void case_compute(const sure_case *c, void *context);

/* Calls `compute` for the case in each environment; it must only compute. Then `judge` in the usual
 * one. */
void in_each_environment(const sure_case *c, case_compute *compute, case_compute *judge,
                         void *context);

/* The same for valid cases of all regimes. */
void in_each_regime(sure_shape shape, case_compute *compute, case_compute *judge, void *context);

/* x with other low bits, `most` at most; and one of ray's and object's numbers, t_min and t_max
 * excepted. */
double bits_changed(double x, uint64_t draw, int most);
sure_case case_changed(const sure_case *c, uint64_t draw, int most);

/* From cases of the regimes that apply, in turn: numbers are changed at random, and what does not
 * lower the score is kept. The score is computed in surroundings 0 to 3, each for a whole climb.
 * The greatest one found. */
typedef double case_score(const sure_case *c, int surroundings, void *context);
typedef struct {
    const regime *from;
    int regimes, climbs, steps;
    sure_case (*start)(const sure_case *from, int climb); /* what is begun with, or NULL */
} climbing;
double climb(sure_shape shape, const climbing *how, case_score *score, void *context);
