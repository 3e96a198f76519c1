/* SPDX-License-Identifier: MIT */
/* What a turn of the bench asks a subject, however it is asked: case by case, in floats, or many
 * rays a call. */
#pragma once

#include "bench.h"

#include "../../cases/case_floats.h"

/* Cases of a turn: few enough for all subjects to find the machine in the same state and the cases
 * in its cache, enough for the clock to tell them. Who asks in blocks asks for many. */
static inline int turn_size(const bench_plan *plan)
{
    return plan->block > 0 ? BENCH_BLOCK_MOST : 512;
}

/* One of a row's turns; the object is the same in all cases of one that is asked in blocks. */
typedef struct {
    const bench_plan *plan;
    sure_shape shape;
    int count;
    const sure_case *cases;
    float_query floats[BENCH_BLOCK_MOST];
    _Alignas(64) union {
        double of_double[8][BENCH_BLOCK_MOST];
        float of_float[8][BENCH_BLOCK_MOST];
    } rays, objects; /* as columns, at whole lines of the cache; objects where it asks for many */
} bench_turn;

/* Asks the plan for floats, blocks? Then so does the turn: all but `cases` is filled in. */
void bench_turn_fill(bench_turn *turn);

typedef struct {
    uint64_t sum, hits;
} answers;

answers bench_ask(const bench_turn *turn, int subject);
