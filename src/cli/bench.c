/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../judge/bench/bench.h"
#include "../judge/bench/instructions.h"
#include "../support/atomic_file.h"
#include "../support/json_file.h"
#include "../support/progress.h"

#include <math.h>
#include <stdio.h>

static regime_rows asked;
static bench_plan plan = {.cases = BENCH_CASES, .repeats = BENCH_REPEATS, .seconds = BENCH_SECONDS};
static const char *json, *repeats;
static sure_tier tier;
static bool of_rays[BENCH_RAYS];
static const char *some_rays; /* the option, if it was given */

static const char *read_tier(const cli_option *row, const char *value)
{
    const char *expected = cli_tier(row, value);
    if (!expected)
        plan.only |= 1u << BENCH_TIER(tier);
    return expected;
}

static bool is_row(int i)
{
    int row = i / BENCH_RAYS;
    return regime_rows_have(&asked, row / REGIMES, row % REGIMES) && of_rays[i % BENCH_RAYS];
}

static int measure_all(void)
{
    static bench_row rows[SURE_SHAPES * REGIMES * BENCH_RAYS];
    int count = 0, total = 0;
    if (!atomic_file_possible(json, stderr))
        return EXIT_OUTPUT;
    bench_print_head(&plan, SUREHIT_FLAGS);
    for (int i = 0; i < SURE_SHAPES * REGIMES * BENCH_RAYS; i++)
        total += is_row(i);
    progress bar = progress_start(instructions_counting() ? NULL : stderr, total);
    for (int i = 0; i < SURE_SHAPES * REGIMES * BENCH_RAYS; i++) {
        int row = i / BENCH_RAYS, rays = i % BENCH_RAYS;
        if (!is_row(i))
            continue;
        if (!bench_measure(&plan, (sure_shape)(row / REGIMES), (regime)(row % REGIMES),
                           (bench_rays)rays, &rows[count])) {
            fputs("surehit bench: error: no memory\n", stderr);
            return EXIT_OUTPUT;
        }
        progress_finish(&bar);
        bench_print_row(&plan, &rows[count++]);
        fflush(stdout);
        progress_step(&bar, 1);
    }
    progress_finish(&bar);
    json_t *found = bench_json(&plan, SUREHIT_FLAGS, rows, count);
    return json_write_file(found, json, stderr) ? 0 : EXIT_OUTPUT;
}

static int run(void)
{
    if (repeats)
        plan.seconds = INFINITY; /* as many as asked for */
    if (!asked.some_regimes) {
        asked.some_regimes = true;
        asked.regimes[REGIME_CAMERA] = asked.regimes[REGIME_TYPICAL] = true;
    }
    if (!some_rays)
        of_rays[BENCH_MIXED] = of_rays[BENCH_HITS] = of_rays[BENCH_MISSES] = true;
    for (int subject = BENCH_TIER(0); subject < BENCH_NAIVE_BLOCK; subject++) {
        if ((plan.only >> subject & 1) && !bench_has(&plan, subject))
            return cli_wrong(
                "--float is for the tiers textbook, certain and exact, with --block certain");
    }
    if (plan.objects && plan.block == 0)
        return cli_wrong("--objects wants --block");
    int status = cli_rows_check(&asked);
    if (status != 0)
        return status;
    if (plan.instructions && !instructions_begin(cli_running->name))
        return EXIT_OUTPUT;
    if (instructions_counting()) { /* times are not wanted there */
        plan.cases = plan.cases < INSTRUCTIONS_CASES ? plan.cases : INSTRUCTIONS_CASES;
        plan.repeats = 1;
        plan.seconds = 0;
        json = NULL;
    }
    return measure_all();
}

static const cli_option options[] = {
    {"shape", "SHAPE", NULL, cli_shape, .to = &asked},
    {"regime", "REGIME", "the kind of cases (default: camera and typical)", cli_regime,
     .to = &asked},
    {"rays", "KIND", "mixed, hits or misses (default: all three), or repeated: in one order",
     cli_mark, .to = of_rays, .words = bench_rays_names, .given = &some_rays},
    {"tier", "TIER", "float32, textbook, stable, certain or exact; may be repeated", read_tier,
     .to = &tier},
    {"cases", "N", "different cases of each kind (default " CLI_NUMERAL(BENCH_CASES) ")", cli_int,
     .to = &plan.cases, .least = 1, .most = BENCH_CASES_MOST},
    {"repeats", "N",
     "of all cases (default " CLI_NUMERAL(BENCH_REPEATS) ", or fewer where they are slow)", cli_int,
     .to = &plan.repeats, .least = 1, .most = BENCH_REPEATS_MOST, .given = &repeats},
    {"float", NULL,
     "in single precision: certain_f and exact_f beside naive and textbook routines in float",
     cli_flag, .to = &plan.floats},
    {"block", "N", "the tiers are asked so many rays a call before one object", cli_int,
     .to = &plan.block, .least = 1, .most = BENCH_BLOCK_MOST},
    {"objects", NULL, "with --block: one ray before so many objects a call", cli_flag,
     .to = &plan.objects},
    CLI_INSTRUCTIONS(&plan.instructions),
    {"json", "FILE", "every figure, for programs", cli_text, .to = &json},
    {0},
};

const cli_command command_bench = {
    .name = "surehit bench",
    .summary = "measure how long each tier takes for an answer",
    .usage = "[OPTION ...]",
    .about = "Measures how long an answer takes: each tier beside a naive routine that checks\n"
             "nothing, one ray at a time, the same cases in turns; of each regime hits and\n"
             "misses mixed, hits alone and misses alone.",
    .options = options,
    .print_more = cli_print_regimes,
    .statuses = "0 measured; 1 output could not be written; 2 wrong usage.",
    .run = run,
};
