#include "options.h"

#include "../judge/bench/bench.h"
#include "../support/atomic_file.h"
#include "../support/json_file.h"

#include <math.h>
#include <stdio.h>

static regime_rows asked;
static bench_plan plan = {.cases = BENCH_CASES, .repeats = BENCH_REPEATS, .seconds = BENCH_SECONDS};
static const char *json, *repeats;
static sure_tier tier;

static const char *read_tier(const cli_option *row, const char *value)
{
    const char *expected = cli_tier(row, value);
    if (!expected)
        plan.only |= 1u << BENCH_TIER(tier);
    return expected;
}

static int measure_all(void)
{
    static bench_row rows[SURE_SHAPES * REGIMES];
    int count = 0;
    if (!atomic_file_possible(json, stderr))
        return EXIT_OUTPUT;
    bench_print_head(&plan, SUREHIT_FLAGS);
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        if (!regime_rows_have(&asked, i / REGIMES, i % REGIMES))
            continue;
        if (!bench_measure(&plan, (sure_shape)(i / REGIMES), (regime)(i % REGIMES), &rows[count])) {
            fputs("surehit bench: error: no memory\n", stderr);
            return EXIT_OUTPUT;
        }
        bench_print_row(&plan, &rows[count++]);
        fflush(stdout);
    }
    json_t *found = bench_json(&plan, SUREHIT_FLAGS, rows, count);
    return json_write_file(found, json, stderr) ? 0 : EXIT_OUTPUT;
}

static int run(void)
{
    if (repeats)
        plan.seconds = INFINITY; /* as many as asked for */
    if (!asked.some_regimes) {
        asked.some_regimes = asked.regimes[REGIME_TYPICAL] = true;
        asked.regimes[REGIME_GRAZING] = asked.regimes[REGIME_TANGENT] = true;
    }
    int status = cli_rows_check(&asked);
    return status == 0 ? measure_all() : status;
}

static const cli_option options[] = {
    {"shape", "SHAPE", NULL, cli_shape, .to = &asked},
    {"regime", "REGIME", "the kind of cases (default: typical, grazing and tangent)", cli_regime,
     .to = &asked},
    {"tier", "TIER", "float32, textbook, stable, certain or exact; may be repeated", read_tier,
     .to = &tier},
    {"cases", "N", "different cases of each kind (default " CLI_NUMERAL(BENCH_CASES) ")", cli_int,
     .to = &plan.cases, .least = 1, .most = BENCH_CASES_MOST},
    {"repeats", "N",
     "of all cases (default " CLI_NUMERAL(BENCH_REPEATS) ", or fewer where they are slow)", cli_int,
     .to = &plan.repeats, .least = 1, .most = BENCH_REPEATS_MOST, .given = &repeats},
    {"json", "FILE", "every figure, for programs", cli_text, .to = &json},
    {0},
};

const cli_command command_bench = {
    .name = "surehit bench",
    .summary = "measure how long each tier takes for an answer",
    .usage = "[OPTION ...]",
    .about = "Measures how long an answer takes: each tier beside a naive routine in double\n"
             "that checks nothing, one ray at a time, the same cases in turns.",
    .options = options,
    .print_more = cli_print_regimes,
    .statuses = "0 measured; 1 output could not be written; 2 wrong usage.",
    .run = run,
};
