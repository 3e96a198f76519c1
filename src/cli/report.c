/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../judge/bench/instructions.h"
#include "../report/report.h"

#include <surehit/version.h>

#include <unistd.h>

#define DEFAULT_COUNT 2000
#define MOST_COUNT 1000000

static report_run of = {
    .plan = {.count = DEFAULT_COUNT}, .version = SUREHIT_VERSION_TEXT, .flags = SUREHIT_FLAGS};

static bool instructions;
static sure_tier tier; /* the last one */

static const char *add(sure_tier of_tier, const char *library)
{
    if (of.count == REPORT_CANDIDATES)
        return "no more than " CLI_NUMERAL(REPORT_CANDIDATES) " candidates";
    return report_add(&of, of_tier, library) ? NULL : "memory for it";
}

static const char *read_tier(const cli_option *row, const char *value)
{
    const char *expected = cli_tier(row, value);
    return expected ? expected : add(tier, NULL);
}

static const char *read_library(const cli_option *row, const char *value)
{
    (void)row;
    return add(0, value);
}

static int run(void)
{
    if (!of.page)
        return cli_wrong("missing '-o FILE'");
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    if (of.plan.processes == 0)
        of.plan.processes = cores <= 0                 ? 1
                            : cores > REPORT_PROCESSES ? REPORT_PROCESSES
                                                       : (int)cores;
    of.words = cli_words;
    const char *outputs[] = {of.page, of.json}, *inputs[REPORT_CANDIDATES];
    const cli_paths all = {outputs, inputs, 2, of.count};
    for (int i = 0; i < of.count; i++)
        inputs[i] = of.list[i].library;
    int status = cli_rows_check(&of.plan.rows);
    if (status == 0)
        status = cli_paths_check(&all);
    if (status != 0)
        return status;
    if (of.count == 0 && !report_choose_all(&of)) {
        fputs("surehit report: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    if (instructions && !instructions_begin(cli_running->name))
        return EXIT_OUTPUT;
    return report_make(&of);
}

static const cli_option options[] = {
    {"o", "FILE", "the page", cli_text, .to = &of.page},
    {"json", "FILE", "what it shows, for programs", cli_text, .to = &of.json},
    {NULL,
     .help = "Who is asked (default: every tier, and the peers that were built with surehit):"},
    {"tier", "TIER", "a tier; may be repeated", read_tier, .to = &tier},
    {"candidate", "FILE",
     "a shared library (surehit/candidate.h says what it defines); may be repeated",
     .read = read_library},
    {NULL, .help = "What:"},
    {"shape", "SHAPE", "of this shape (default: all); may be repeated", cli_shape,
     .to = &of.plan.rows},
    {"regime", "REGIME", "the kind of cases (default: all); may be repeated", cli_regime,
     .to = &of.plan.rows},
    {"count", "N",
     "cases of each shape and regime (default " CLI_NUMERAL(
         DEFAULT_COUNT) "); 5 times as many of camera, a quarter of bits and degenerate",
     cli_number, .to = &of.plan.count, .least = 1, .most = MOST_COUNT},
    {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &of.plan.seed,
     .most = UINT64_MAX},
    {NULL, .help = "How:"},
    {"processes", "N", "that judge at a time (default: one a core)", cli_int,
     .to = &of.plan.processes, .least = 1, .most = REPORT_PROCESSES},
    CLI_INSTRUCTIONS(&instructions),
    {"quiet", NULL, "no progress bar and no line at the end", cli_flag, .to = &of.quiet},
    {0},
};

const cli_command command_report = {
    .name = "surehit report",
    .summary = "set routines side by side, on one page to look at",
    .usage = "-o REPORT.html [OPTION ...]",
    .about = "Asks several routines for ray-surface intersections the same cases and writes\n"
             "one page: what each gets wrong, where, by how much, and what it costs. The page\n"
             "needs no other file.",
    .options = options,
    .print_more = cli_print_regimes,
    .statuses = "0 written, whatever it says; 1 output could not be written, or a\n"
                "candidate could not be asked (the page says why); 2 wrong usage.",
    .run = run,
};
