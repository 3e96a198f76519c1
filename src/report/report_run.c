#define _POSIX_C_SOURCE 200809L /* isatty, gmtime, open_memstream */

#include "report.h"

#include "../judge/bench/bench.h"
#include "../judge/truth.h"
#include "../support/atomic_file.h"
#include "../support/json_file.h"
#include "../support/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

bool report_fail(const char *message)
{
    fprintf(stderr, "surehit report: error: %s\n", message);
    return false;
}

/* The command as it was given; a word with anything unusual in it stands in quotes. */
static char *command_of(char *const *words)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
    fputs("surehit report", out);
    for (int i = 0; words[i]; i++)
        fprintf(out, strpbrk(words[i], " '\"$&;<>()|*?") ? " '%s'" : " %s", words[i]);
    fclose(out);
    return text;
}

static bool is_all_asked(const report_run *run)
{
    bool all = true;
    for (int i = 0; i < run->count; i++) {
        const char *trouble = report_trouble(&run->list[i]);
        if (!trouble)
            continue;
        fprintf(stderr, "surehit report: error: %s\n", trouble);
        all = false;
    }
    return all;
}

static bool write_page(const char *path, const json_t *found)
{
    atomic_file file;
    if (!atomic_file_open(path, stderr, &file))
        return false;
    if (report_print_page(file.stream, found))
        return atomic_file_finish(&file, stderr);
    atomic_file_discard(&file);
    return report_fail("no memory");
}

static bool is_shown(const report_run *run)
{
    return !run->quiet && isatty(STDERR_FILENO);
}

static bool gather(report_run *run)
{
    progress bar = progress_start(is_shown(run) ? stderr : NULL, REPORT_STEPS(run->count));
    run->plan.reference = truth_has_reference();
    const char *wrong = report_gather(&run->plan, run->list, run->count, &bar);
    progress_finish(&bar);
    return !wrong || report_fail(wrong);
}

/* What was found, and how. NULL after a line to standard error. After the judging: what draws keeps
 * threads, and a process that forks should have none. For the same reason what is timed is drawn
 * first. */
static json_t *document(report_run *run, double seconds)
{
    char date[32], *command = command_of(run->words);
    time_t now = time(NULL);
    json_t *scenes = run->scenes ? report_trade_draw(&run->trade, is_shown(run)) : NULL, *found;
    json_t *pictures = run->scenes && !scenes ? NULL : report_pictures_draw();
    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    if (!pictures) {
        free(command);
        return NULL;
    }
    found = report_json(&run->plan, run->list, run->count);
    json_t *made = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:f, s:o?, s:o}", "version",
                             run->version, "cpu", bench_cpu_name(), "compiler",
                             bench_compiler_name(), "flags", run->flags, "date", date, "command",
                             command, "seconds", seconds, "scenes", scenes, "pictures", pictures);
    free(command);
    if (found && made && json_object_update_new(found, made) == 0)
        return found;
    report_fail("no memory, or a name that is no text");
    json_decref(found);
    return NULL;
}

static report_outcome make(report_run *run)
{
    double started = progress_clock();
    if (!gather(run))
        return REPORT_TROUBLE;
    double seconds = progress_clock() - started;
    json_t *found = document(run, seconds);
    bool written = found && json_write_file(json_incref(found), run->json, stderr) &&
                   write_page(run->page, found);
    json_decref(found);
    if (!written)
        return REPORT_TROUBLE;
    if (!run->quiet)
        printf("%s: %d %s, %.0f s\n", run->page, run->count,
               run->count == 1 ? "routine" : "routines", seconds);
    return is_all_asked(run) ? REPORTED : REPORT_TROUBLE;
}

report_outcome report_make(report_run *run)
{
    /* Before the judging, which is long. */
    bool read = !run->scenes || report_trade_read(run->scenes, &run->trade);
    report_outcome outcome = read ? make(run) : REPORT_NO_SCENES;
    report_trade_free(&run->trade);
    return outcome;
}
