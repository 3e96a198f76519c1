/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../support/progress.h"

#include <stdio.h>
#include <unistd.h>

#define DEFAULT_COUNT 1000

static regime_rows rows;
static uint64_t count = DEFAULT_COUNT, seed;
static bool named;
static const char *numbered; /* an option that was given */

static void write_cases(sure_shape shape, regime which, progress *bar)
{
    char text[CASE_LINE_MAX];
    for (uint64_t i = 0; i < count && !ferror(stdout); i++) {
        sure_case question = regime_case(shape, which, seed, i);
        case_print(&question, text);
        fputs(text, stdout);
        printf(named ? " # %s\n" : "\n", regime_name(which));
        progress_step(bar, 1);
    }
}

static int run(void)
{
    int status = cli_rows_numbers(&rows, numbered, &count, &seed);
    if (status == 0)
        status = cli_rows_check(&rows);
    int64_t total = 0;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++)
        total += regime_rows_have(&rows, i / REGIMES, i % REGIMES);
    /* What runs over a terminal shows by itself how far it is. */
    progress bar =
        progress_start(isatty(STDOUT_FILENO) ? NULL : stderr, progress_total(total, count));
    for (int i = 0; status == 0 && i < SURE_SHAPES * REGIMES; i++) {
        if (regime_rows_have(&rows, i / REGIMES, i % REGIMES))
            write_cases((sure_shape)(i / REGIMES), (regime)(i % REGIMES), &bar);
    }
    progress_finish(&bar);
    return status;
}

static const cli_option options[] = {
    {"shape", "SHAPE", NULL, cli_shape, .to = &rows},
    {"regime", "REGIME", "the kind of cases", cli_regime, .to = &rows},
    {"count", "N", "of each shape and regime (default " CLI_NUMERAL(DEFAULT_COUNT) ")", cli_number,
     .to = &count, .most = UINT64_MAX, .given = &numbered},
    {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &seed,
     .most = UINT64_MAX, .given = &numbered},
    CLI_SET(&rows),
    {"named", NULL, "with a remark behind each, that names its regime: `# rim`", cli_flag,
     .to = &named},
    {0},
};

const cli_command command_cases = {
    .name = "surehit cases",
    .summary = "write cases, one a line: of pictures and of the hard kinds",
    .usage = "[--shape SHAPE ...] [--regime REGIME ...] [OPTION ...]",
    .about = "Writes cases, one a line: SHAPE ox oy oz dx dy dz t_min t_max, and the object's\n"
             "numbers. Without --shape those of all shapes, without --regime those of all\n"
             "regimes. What reads case lines here passes over remarks, and the judge takes the\n"
             "regime from there.",
    .options = options,
    .print_more = cli_print_sets,
    .statuses = "0 written; 1 output could not be written; 2 wrong usage.",
    .run = run,
};
