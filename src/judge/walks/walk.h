/* SPDX-License-Identifier: MIT */
/* Walks (docs/walks.md): a routine is asked, the ray goes to the answer, and it is asked again from
 * the rounded point. Every start and every answer is held against the truth. */
#pragma once

#include "setting.h"

#include "../../support/progress.h"
#include "../truth.h"

/* clang-format off */
#define EACH_WALK_FAULT(DO) \
    DO(LOST, "lost")   /* a solid that is ahead is not met */ \
    DO(GHOST, "ghost") /* one is met that is not ahead */ \
    DO(ZERO, "zero")   /* it gets not even half as far as it should */ \
    DO(PAST, "past")   /* ... more than twice as far, or past the other solid's boundary */ \
    DO(SIDE, "side")   /* the next start is not on that side of the surface that it should be */
/* clang-format on */

#define WALK_FAULT(NAME, name) WALK_##NAME,
typedef enum { EACH_WALK_FAULT(WALK_FAULT) WALK_FAULTS } walk_fault;
#undef WALK_FAULT

const char *walk_fault_name(int which);

/* Who walks. */
typedef struct {
    candidate *asked; /* NULL: a tier */
    sure_tier tier;
    double nudge; /* so far behind the answer it starts again; NAN: where sure_spawn tells */
} walk_routine;

/* The step that led to a fault. */
typedef struct {
    setting in;
    sure_ray ray;
    int met;         /* a solid; -1: none */
    sure_vec3 start; /* behind it */
} walk_step;

typedef struct {
    uint64_t steps, walks;
    uint64_t stopped; /* no point to start from, by sure_spawn; or it can't be asked */
    uint64_t faults[WALK_FAULTS];
    walk_step first[WALK_FAULTS];
} walk_sum;

/* The one more, too. */
void walk_add(walk_sum *sum, const walk_sum *one);

/* A run of `surehit walk`. */
typedef struct {
    candidate_options how;
    const char *library; /* its path; NULL: a tier */
    walk_routine by;
    int by_reference;       /* the truth: surehit-reference; else the tier exact */
    regime_rows rows;       /* its shapes */
    bool kinds[WALK_KINDS]; /* none: all */
    uint64_t steps, seed;
    int threads;   /* 0: one a core */
    bool required; /* no fault */
    progress *bar; /* of steps; or NULL */
    const char *json;
} walk_plan;

/* At least plan->steps steps of that kind, or as many walks that have to be stopped: the same for
 * the same seed, whatever the number of threads. `known` is asked for the truth. False after a
 * message. */
bool walk_steps(const walk_plan *plan, truth *known, sure_shape shape, walk_kind kind,
                walk_sum *sum, char *message);

/* Every row is walked and printed as it comes. Returns 0, or 1 where a fault is found and none was
 * required; after a line to standard error 1 where the JSON file can't be written, 2 where there is
 * no candidate or truth. */
int walk_run(const walk_plan *plan);
