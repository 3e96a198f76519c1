#include "options.h"

#include "../judge/bench/bench_report.h"
#include "../support/atomic_file.h"
#include "../support/json_file.h"

#include <math.h>
#include <stdio.h>

typedef struct {
    cli_rows rows;
    bench_plan plan;
    const char *json;
} request;

static const char *read_tier(const cli_option *row, const char *value)
{
    bench_plan *plan = row->to;
    sure_tier tier;
    if (!sure_tier_from_name(value, &tier))
        return cli_tier_names();
    for (int i = 0; i < BENCH_SUBJECTS; i++)
        plan->subjects[i] = i == BENCH_TIER(tier);
    return NULL;
}

static int measure(const request *asked, const bench_machine *machine, bench_row *rows, int *count)
{
    bench_print_head(stdout, &asked->plan, machine);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            if (!cli_rows_have(&asked->rows, shape, which))
                continue;
            if (!bench_measure(&asked->plan, (sure_shape)shape, (regime)which, &rows[*count])) {
                fputs("surehit bench: error: no memory\n", stderr);
                return EXIT_OUTPUT;
            }
            bench_print_row(stdout, &asked->plan, &rows[(*count)++]);
            fflush(stdout);
        }
    }
    return 0;
}

static int measure_all(const request *asked)
{
    static bench_row rows[SURE_SHAPES * REGIMES];
    const bench_machine machine = {bench_compiler_name(), SUREHIT_FLAGS, bench_cpu_name()};
    int count = 0;
    if (asked->json && !atomic_file_possible(asked->json, stderr))
        return EXIT_OUTPUT;
    int status = measure(asked, &machine, rows, &count);
    if (status != 0 || !asked->json)
        return status;
    return json_write_file(bench_json(&asked->plan, &machine, rows, count), asked->json, stderr)
               ? 0
               : EXIT_OUTPUT;
}

int command_bench(int count, char **words)
{
    request asked = {.plan = bench_usual_plan()};
    const char *repeats = NULL;
    const cli_option options[] = {
        {"shape", "SHAPE", cli_shape_names(), cli_shape, .to = &asked.rows},
        {"regime", "REGIME", "the kind of cases (default: typical, grazing and tangent)",
         cli_regime, .to = &asked.rows},
        {"tier", "TIER", cli_tier_names(), read_tier, .to = &asked.plan},
        {"cases", "N", "different cases of each kind (default " CLI_NUMERAL(BENCH_CASES) ")",
         cli_int, .to = &asked.plan.cases, .least = 1, .most = BENCH_CASES_MOST},
        {"repeats", "N",
         "of all cases (default " CLI_NUMERAL(BENCH_REPEATS) ", or fewer where they are slow)",
         cli_int, .to = &asked.plan.repeats, .least = 1, .most = BENCH_REPEATS_MOST,
         .given = &repeats},
        {"json", "FILE", "every figure, for programs", cli_text, .to = &asked.json},
        {0},
    };
    const cli_command command = {
        .name = "surehit bench",
        .usage = "[OPTION ...]",
        .about = "Measures how long an answer takes: each tier beside a naive routine in double\n"
                 "that checks nothing, one ray at a time, the same cases in turns.",
        .options = options,
        .print_more = cli_print_regimes,
        .statuses = "0 measured; 1 output could not be written; 2 wrong usage.",
    };
    int status;
    if (!cli_read(&command, count, words, &status))
        return status;
    if (repeats)
        asked.plan.seconds = INFINITY; /* as many as asked for */
    if (!asked.rows.some_regimes) {
        asked.rows.some_regimes = asked.rows.regimes[REGIME_TYPICAL] = true;
        asked.rows.regimes[REGIME_GRAZING] = asked.rows.regimes[REGIME_TANGENT] = true;
    }
    status = cli_rows_check(&command, &asked.rows);
    return cli_finish(&command, status == 0 ? measure_all(&asked) : status);
}
