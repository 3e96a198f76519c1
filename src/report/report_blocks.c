/* SPDX-License-Identifier: MIT */
#include "report.h"

#include "../judge/bench/bench.h"

static const int sizes[] = {1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096};
enum { SIZES = sizeof sizes / sizeof *sizes, CERTAIN = BENCH_TIER(SURE_TIER_CERTAIN) };

/* So many rays a call, 0: one by one. */
static bench_row measured(sure_shape shape, int rays)
{
    const bench_plan plan = {.cases = BENCH_BLOCK_MOST,
                             .repeats = 9,
                             .seconds = 1,
                             .only = 1U << CERTAIN,
                             .block = rays};
    bench_row row;
    if (!bench_measure(&plan, shape, REGIME_TYPICAL, BENCH_MIXED, &row))
        row.cases = 0;
    return row;
}

static json_t *nanoseconds_of(const bench_row *row, int subject)
{
    const bool known = row->cases > 0 && row->results[subject].asked;
    return known ? json_real(row->results[subject].nanoseconds.median) : json_null();
}

static json_t *blocks_of(sure_shape shape)
{
    const bench_row alone = measured(shape, 0);
    json_t *list = json_array();
    for (int i = 0; i < SIZES; i++) {
        const bench_row row = measured(shape, sizes[i]);
        json_array_append_new(list, json_pack("{s:i, s:o, s:o}", "rays", sizes[i], "certain",
                                              nanoseconds_of(&row, CERTAIN), "naive_block",
                                              nanoseconds_of(&row, BENCH_NAIVE_BLOCK)));
    }
    return json_pack("{s:s, s:o, s:o, s:o}", "shape", sure_shape_name(shape), "naive",
                     nanoseconds_of(&alone, BENCH_NAIVE), "certain",
                     nanoseconds_of(&alone, CERTAIN), "calls", list);
}

json_t *report_blocks(const report_plan *plan)
{
    json_t *found = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (regime_rows_have(&plan->rows, shape, REGIME_TYPICAL))
            json_array_append_new(found, blocks_of((sure_shape)shape));
    }
    return found;
}
