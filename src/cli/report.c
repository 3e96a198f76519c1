#define _DEFAULT_SOURCE /* sysconf */

#include "options.h"

#include "../report/report_run.h"
#include "../support/atomic_file.h"

#include <unistd.h>

#define DEFAULT_COUNT 2000
#define MOST_COUNT 1000000
#define MOST_PROCESSES 256

#define NO_ROOM "no more than " CLI_NUMERAL(REPORT_CANDIDATES) " candidates"

static const char *read_tier(const cli_option *row, const char *value)
{
    report_run *run = row->to;
    sure_tier tier;
    if (run->count == REPORT_CANDIDATES)
        return NO_ROOM;
    if (!sure_tier_from_name(value, &tier))
        return cli_tier_names();
    report_add_tier(run, tier);
    return NULL;
}

static const char *read_library(const cli_option *row, const char *value)
{
    report_run *run = row->to;
    if (run->count == REPORT_CANDIDATES)
        return NO_ROOM;
    return report_add_library(run, value) ? NULL : "memory for it";
}

static int make(report_run *run, const cli_rows *rows)
{
    static const int statuses[] = {
        [REPORTED] = 0, [REPORT_TROUBLE] = EXIT_OUTPUT, [REPORT_NO_SCENES] = EXIT_USAGE};
    if (!atomic_file_possible(run->page, stderr) ||
        (run->json && !atomic_file_possible(run->json, stderr)))
        return EXIT_OUTPUT;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++)
        run->plan.wanted[i / REGIMES][i % REGIMES] = cli_rows_have(rows, i / REGIMES, i % REGIMES);
    if (run->count == 0 && !report_choose_all(run)) {
        fputs("surehit report: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    return statuses[report_make(run)];
}

int command_report(int count, char **words)
{
    static report_candidate list[REPORT_CANDIDATES];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    cli_rows rows = {.some_shapes = false};
    report_run run = {
        .plan = {.count = DEFAULT_COUNT, .processes = cores > 0 ? (int)cores : 1},
        .list = list,
        .version = SUREHIT_VERSION,
        .flags = SUREHIT_FLAGS,
        .word_count = count,
        .words = words,
    };
    const cli_option options[] = {
        {"o", "FILE", "the page", cli_text, .to = &run.page},
        {"json", "FILE", "what it shows, for programs", cli_text, .to = &run.json},
        {NULL,
         .help = "Who is asked (default: every tier, and the peers that were built with surehit):"},
        {"tier", "TIER", "a tier; may be repeated", read_tier, .to = &run},
        {"candidate", "FILE",
         "a shared library (surehit/candidate.h says what it defines); may be repeated",
         read_library, .to = &run},
        {NULL, .help = "What:"},
        {"shape", "SHAPE", "of this shape (default: all); may be repeated", cli_shape, .to = &rows},
        {"regime", "REGIME", "the kind of cases (default: all); may be repeated", cli_regime,
         .to = &rows},
        {"count", "N",
         "cases of each shape and regime (default " CLI_NUMERAL(
             DEFAULT_COUNT) "); 20 times as many of typical, a quarter of bits and degenerate",
         cli_number, .to = &run.plan.count, .least = 1, .most = MOST_COUNT},
        {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &run.plan.seed,
         .most = UINT64_MAX},
        {"scenes", "FOLDER", "all scenes there (*.rt) by every tier, too", cli_text,
         .to = &run.scenes},
        {NULL, .help = "How:"},
        {"processes", "N", "that judge at a time (default: one a core)", cli_int,
         .to = &run.plan.processes, .least = 1, .most = MOST_PROCESSES},
        {"quiet", NULL, "no progress bar and no line at the end", cli_flag, .to = &run.quiet},
        {0},
    };
    const cli_command command = {
        .name = "surehit report",
        .usage = "-o REPORT.html [OPTION ...]",
        .about =
            "Asks several routines for ray-surface intersections the same cases and writes one\n"
            "page: what each gets wrong, where, by how much, and what it costs. The page needs\n"
            "no other file.",
        .options = options,
        .print_more = cli_print_regimes,
        .statuses = "0 written, whatever it says; 1 output could not be written, or a\n"
                    "candidate could not be asked (the page says why); 2 wrong usage, or a scene\n"
                    "that cannot be read.",
    };
    int status;
    if (!cli_read(&command, count, words, &status))
        return status;
    if (!run.page)
        return cli_wrong(&command, "missing", "-o FILE");
    status = cli_rows_check(&command, &rows);
    return cli_finish(&command, status == 0 ? make(&run, &rows) : status);
}
