#include "options.h"

#include "../judge/bench/bench_report.h"
#include "../support/atomic_file.h"
#include "../support/json_file.h"

#include <math.h>
#include <stdio.h>

static regime_rows asked;
static bench_plan plan;
static const char *json, *repeats;

static const char *read_tier(const cli_option *row, const char *value)
{
    sure_tier tier;
    if (!sure_tier_from_name(value, &tier))
        return cli_tier(row, value);
    for (int i = 0; i < BENCH_SUBJECTS; i++)
        plan.subjects[i] = i == BENCH_TIER(tier);
    return NULL;
}

static void begin(void)
{
    plan = bench_usual_plan();
}

static int measure_all(void)
{
    static bench_row rows[SURE_SHAPES * REGIMES];
    const bench_machine machine = {bench_compiler_name(), SUREHIT_FLAGS, bench_cpu_name()};
    int count = 0;
    if (!atomic_file_possible(json, stderr))
        return EXIT_OUTPUT;
    bench_print_head(stdout, &plan, &machine);
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        if (!regime_rows_have(&asked, i / REGIMES, i % REGIMES))
            continue;
        if (!bench_measure(&plan, (sure_shape)(i / REGIMES), (regime)(i % REGIMES), &rows[count])) {
            fputs("surehit bench: error: no memory\n", stderr);
            return EXIT_OUTPUT;
        }
        bench_print_row(stdout, &plan, &rows[count++]);
        fflush(stdout);
    }
    return json_write_file(bench_json(&plan, &machine, rows, count), json, stderr) ? 0
                                                                                   : EXIT_OUTPUT;
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
    {"tier", "TIER", NULL, .read = read_tier},
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
    .begin = begin,
    .run = run,
};
