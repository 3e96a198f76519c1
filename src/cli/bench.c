#include "args.h"
#include "choice.h"
#include "commands.h"

#include "../judge/bench/bench_report.h"
#include "../support/atomic_file.h"

#include <math.h>
#include <stdio.h>

enum { HELP, SHAPE, REGIME, TIER, CASES, REPEATS, JSON };

static const args_option options[] = {
    [HELP] = {"--help", false}, [SHAPE] = {"--shape", true}, [REGIME] = {"--regime", true},
    [TIER] = {"--tier", true},  [CASES] = {"--cases", true}, [REPEATS] = {"--repeats", true},
    [JSON] = {"--json", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help;
    choice rows;
    bench_plan plan;
    const char *json;
} request;

static void print_help(void)
{
    fputs("Usage: surehit bench [OPTION ...]\n"
          "\n"
          "Measures how long an answer takes: each tier beside a naive routine in double\n"
          "that checks nothing, one ray at a time, the same cases in turns.\n"
          "\n"
          "  --shape SHAPE    one of",
          stdout);
    for (int i = 0; i < SURE_SHAPES; i++)
        printf(" %s", sure_shape_name((sure_shape)i));
    fputs("\n  --regime REGIME  the kind of cases (default: typical, grazing and tangent)\n"
          "  --tier TIER      one of",
          stdout);
    for (int i = 0; i < SURE_TIERS; i++)
        printf(" %s", sure_tier_name((sure_tier)i));
    printf("\n  --cases N        different cases of each kind (default %d)\n"
           "  --repeats N      of all cases (default %d, or fewer where they are slow)\n"
           "  --json FILE      every figure, for programs\n",
           BENCH_CASES, BENCH_REPEATS);
    choice_print_regimes();
    fputs("\n"
          "Exit status: 0 measured; 1 output could not be written; 2 wrong usage.\n",
          stdout);
}

static int set_tier(const args *line, const char *value, request *asked)
{
    sure_tier tier;
    if (!sure_tier_from_name(value, &tier))
        return args_wrong_value(line, "--tier", value, "the name of a tier");
    for (int i = 0; i < BENCH_SUBJECTS; i++)
        asked->plan.subjects[i] = i == BENCH_TIER(tier);
    return 0;
}

static int set_number(const args *line, int option, const char *value, int most, int *number)
{
    uint64_t read;
    char expected[64];
    if (!args_number(value, 1, (uint64_t)most, &read)) {
        snprintf(expected, sizeof expected, "a whole number from 1 to %d", most);
        return args_wrong_value(line, options[option].name, value, expected);
    }
    *number = (int)read;
    return 0;
}

/* Some regimes mean nothing for some shapes. */
static int check_rows(const args *line, const request *asked)
{
    const char *missing = "";
    for (int which = 0; which < REGIMES; which++) {
        for (int shape = 0; shape < SURE_SHAPES; shape++) {
            if (choice_has(&asked->rows, shape, which))
                return 0;
        }
        if (asked->rows.regimes[which])
            missing = regime_name((regime)which);
    }
    return args_wrong_value(line, "--regime", missing, "a regime that the shape has");
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    bench_plan *plan = &asked->plan;
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case SHAPE: status = choice_add_shape(line, value, &asked->rows); break;
        case REGIME: status = choice_add_regime(line, value, &asked->rows); break;
        case TIER: status = set_tier(line, value, asked); break;
        case CASES: status = set_number(line, option, value, BENCH_CASES_MOST, &plan->cases); break;
        case REPEATS:
            status = set_number(line, option, value, BENCH_REPEATS_MOST, &plan->repeats);
            plan->seconds = INFINITY; /* as many as asked for */
            break;
        case JSON: asked->json = value; break;
        case ARGS_OPERAND: status = args_wrong(line, "one word too many:", value); break;
        default: status = EXIT_USAGE;
        }
    }
    if (!asked->rows.some_regimes) {
        asked->rows.some_regimes = asked->rows.regimes[REGIME_TYPICAL] = true;
        asked->rows.regimes[REGIME_GRAZING] = asked->rows.regimes[REGIME_TANGENT] = true;
    }
    return status == 0 ? check_rows(line, asked) : status;
}

static int measure(const request *asked, const bench_machine *machine, bench_row *rows, int *count)
{
    bench_print_head(stdout, &asked->plan, machine);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            if (!choice_has(&asked->rows, shape, which))
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

static int write_json(const request *asked, const bench_machine *machine, const bench_row *rows,
                      int count)
{
    atomic_file file;
    if (!atomic_file_open(asked->json, stderr, &file))
        return EXIT_OUTPUT;
    bench_print_json(file.stream, &asked->plan, machine, rows, count);
    return atomic_file_finish(&file, stderr) ? 0 : EXIT_OUTPUT;
}

int command_bench(int count, char **words)
{
    static bench_row rows[SURE_SHAPES * REGIMES];
    int row_count = 0;
    args line = {"surehit bench", words, count, 0, false};
    request asked = {.plan = bench_usual_plan()};
    int status = read_words(&line, &asked);
    if (status == 0 && asked.help) {
        print_help();
        return args_flush_output(&line, 0);
    }
    if (status == 0 && asked.json && !atomic_file_possible(asked.json, stderr))
        status = EXIT_OUTPUT;
    bench_machine machine = {bench_compiler_name(), SUREHIT_FLAGS, bench_cpu_name()};
    if (status == 0)
        status = measure(&asked, &machine, rows, &row_count);
    if (status == 0 && asked.json)
        status = write_json(&asked, &machine, rows, row_count);
    return status == EXIT_USAGE ? status : args_flush_output(&line, status);
}
