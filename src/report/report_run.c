/* SPDX-License-Identifier: MIT */
#include "report.h"

#include "../judge/bench/bench.h"
#include "../judge/bench/instructions.h"
#include "../judge/referee/referee_report.h"
#include "../judge/truth.h"
#include "../support/atomic_file.h"
#include "../support/folder.h"
#include "../support/json_file.h"
#include "../support/shell.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

bool report_fail(const char *message)
{
    fprintf(stderr, "surehit report: error: %s\n", message);
    return false;
}

/* Who is asked. */

/* Where both were built; else where the build has them installed, and nowhere else. */
#define PEERS_FOLDER "reference/peers"
#define PEER_BEGIN "libpeer-"
#define PEER_END ".so"

/* The file's name without what every such name has: libpeer-kahan.so is kahan. It lives as long as
 * the program. */
static const char *short_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (strncmp(name, PEER_BEGIN, strlen(PEER_BEGIN)) == 0)
        name += strlen(PEER_BEGIN);
    else if (strncmp(name, "lib", 3) == 0)
        name += 3;
    return strndup(name, strcspn(name, "."));
}

bool report_add(report_run *run, sure_tier tier, const char *library)
{
    report_candidate *who = &run->list[run->count++];
    *who = (report_candidate){.name = library ? short_name(library) : sure_tier_name(tier),
                              .library = library,
                              .tier = tier};
    return who->name != NULL;
}

bool report_choose_all(report_run *run)
{
    char way[4096];
    folder_listing found;
    for (int tier = 0; tier < SURE_TIERS; tier++)
        report_add(run, (sure_tier)tier, NULL);
    bool is_built = folder_from_build(PEERS_FOLDER, way, sizeof way);
    char *folder = realpath(is_built ? way : SUREHIT_PEERS, NULL);
    if (!folder)
        return true;
    bool done = true;
    folder_list(folder, PEER_BEGIN, PEER_END, NULL, &found);
    for (int i = 0; done && i < found.count && run->count < REPORT_CANDIDATES; i++) {
        char *path = folder_path(folder, found.names[i], strlen(found.names[i]), "");
        done = path && report_add(run, 0, path);
    }
    folder_free(&found);
    free(folder);
    return done;
}

/* What was found. */

/* Made of page.html (meson.build). */
extern const char report_page[];

#define PLACE "@REPORT@" /* in the page: there the document goes */

/* The first shape's trouble; NULL: none. */
static const char *trouble_of(const report_candidate *who)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (who->shapes[shape].trouble[0] != '\0')
            return who->shapes[shape].trouble;
    }
    return NULL;
}

static json_t *t_of(const verdict *sum)
{
    json_t *found = judging_errors(&sum->t_ulps);
    json_object_set_new(found, "by_powers_of_two", json_counts(sum->t_classes, SIZE_CLASSES));
    return found;
}

static json_t *faults_of_row(const verdict *sum)
{
    json_t *found = json_object();
    for (int i = 0; i < FAULTS; i++) {
        if (sum->faults[i] > 0)
            json_object_set_new(found, fault_name(i), json_integer((json_int_t)sum->faults[i]));
    }
    return found;
}

/* Of a row that is right in all there is nothing to tell of wrong decisions. */
static json_t *row_of(const judging_row *row)
{
    const verdict *sum = &row->sum;
    const margins told = margins_of(MARGIN_SIZE);
    bool wrong = sum->wrong > 0;
    return json_pack(
        "{s:s, s:s, s:I, s:I, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o*, s:o*}", "shape",
        sure_shape_name(row->shape), "regime", judging_row_name(row->which), "cases",
        (json_int_t)report_row_cases(row), "valid", (json_int_t)sum->valid, "wrong",
        (json_int_t)sum->wrong, "breaches", (json_int_t)verdict_breaches(sum), "unasked",
        (json_int_t)sum->unasked, "nanoseconds", judging_time(row->times.candidate), "instructions",
        judging_time(row->instructions.candidate), "t_ulps", t_of(sum), "t_extents",
        judging_errors(&sum->t_extents), "t_pixels", judging_errors(&sum->t_pixels), "faults",
        faults_of_row(sum), "decisions", wrong ? referee_events(&row->looked_at) : NULL, "margins",
        wrong ? referee_margins(&told, &row->looked_at) : NULL);
}

/* In the order of shapes and regimes; those that were asked. */
static json_t *rows_of(const report_candidate *who)
{
    json_t *list = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            const judging_row *row = &who->shapes[shape].rows[which];
            if (report_row_cases(row) > 0)
                json_array_append_new(list, row_of(row));
        }
    }
    return list;
}

static json_t *worst_of(const report_candidate *who)
{
    json_t *list = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        const report_shape *of = &who->shapes[shape];
        for (int i = 0; i < of->worst_count; i++)
            json_array_append_new(list, worst_json(&of->worst[i]));
    }
    return list;
}

static json_t *candidate_of(const report_candidate *who)
{
    static const char *const truths[] = {"exact", "reference", "like"};
    bool in_float = false, with_normals = false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        in_float |= who->shapes[shape].in_float;
        with_normals |= who->shapes[shape].with_normals;
    }
    return json_pack("{s:o, s:o, s:o, s:s?, s:s, s:b, s:b, s:o, s:o, s:o}", "name",
                     json_text(who->name), "says", identity_json(&who->shapes[0].who), "library",
                     who->library ? json_text(who->library) : json_null(), "tier",
                     who->library ? NULL : sure_tier_name(who->tier), "truth", truths[who->truth],
                     "in_float", in_float, "with_normals", with_normals, "trouble",
                     trouble_of(who) ? json_text(trouble_of(who)) : json_null(), "rows",
                     rows_of(who), "worst", worst_of(who));
}

static json_t *shape_names(void)
{
    json_t *list = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++)
        json_array_append_new(list, json_string(sure_shape_name((sure_shape)shape)));
    return list;
}

static json_t *regimes_of(const report_plan *plan)
{
    json_t *list = json_array();
    for (int which = 0; which < REGIMES; which++)
        json_array_append_new(list,
                              json_pack("{s:s, s:I}", "name", regime_name((regime)which), "cases",
                                        (json_int_t)report_cases(plan, (regime)which)));
    return list;
}

/* NULL: no memory, or a name is no UTF-8. */
static json_t *candidates_of(const report_run *run)
{
    json_t *list = json_array();
    for (int i = 0; i < run->count; i++) {
        if (json_array_append_new(list, candidate_of(&run->list[i])) == 0)
            continue;
        json_decref(list);
        return NULL;
    }
    return list;
}

/* This program, and behind it the command and its words; NULL: the program alone. */
static char *command_of(char *const *words)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
    shell_print_program(out);
    fputs(words ? " report" : "", out);
    for (int i = 0; words && words[i]; i++) {
        fputc(' ', out);
        shell_print(out, words[i]);
    }
    fclose(out);
    return text;
}

static bool is_all_asked(const report_run *run)
{
    bool all = true;
    for (int i = 0; i < run->count; i++) {
        const char *trouble = trouble_of(&run->list[i]);
        if (!trouble)
            continue;
        fprintf(stderr, "surehit report: error: %s\n", trouble);
        all = false;
    }
    return all;
}

/* A < is escaped, since one in a string could end the page's script. */
static bool write_page(const char *path, const json_t *found)
{
    const char *place = strstr(report_page, PLACE);
    char *text = json_dumps(found, JSON_COMPACT | JSON_MEASURED);
    atomic_file file;
    if (!text)
        return report_fail("no memory");
    bool opened = atomic_file_open(path, stderr, &file);
    if (opened) {
        fwrite(report_page, 1, (size_t)(place - report_page), file.stream);
        for (const char *at = text; *at != '\0'; at++)
            fprintf(file.stream, *at == '<' ? "\\u003c" : "%c", *at);
        fputs(place + strlen(PLACE), file.stream);
    }
    free(text);
    return opened && atomic_file_finish(&file, stderr);
}

static bool gather(report_run *run)
{
    progress bar = progress_start(run->quiet ? NULL : stderr, REPORT_STEPS(run->count));
    run->plan.reference = truth_has_reference();
    const char *wrong = report_gather(&run->plan, run->list, run->count, &bar);
    progress_finish(&bar);
    return !wrong || report_fail(wrong);
}

/* What was found, and how. NULL after a line to standard error. After the judging: what draws keeps
 * threads, and a process that forks should have none. */
static json_t *document(report_run *run, double seconds)
{
    const report_plan *plan = &run->plan;
    char date[32], seed[24]; /* a number of JSON may lose digits */
    time_t now = time(NULL);
    json_t *blocks = report_blocks(plan), *pictures = report_pictures_draw();
    if (!pictures) {
        json_decref(blocks);
        return NULL;
    }
    char *program = command_of(NULL), *command = command_of(run->words);
    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)plan->seed);
    json_t *found = json_pack(
        "{s:i, s:s, s:I, s:i, s:o, s:o, s:o, s:s, s:s, s:s, s:s, s:s, s:o, s:o, s:f, s:o, s:o}",
        "surehit_report", 1, "seed", seed, "count", (json_int_t)plan->count, "reference_cases",
        REPORT_REFERENCE_CASES, "shapes", shape_names(), "regimes", regimes_of(plan), "candidates",
        candidates_of(run), "version", run->version, "cpu", bench_cpu_name(), "compiler",
        bench_compiler_name(), "flags", run->flags, "date", date, "program",
        json_text(program ? program : ""), "command", json_text(command ? command : ""), "seconds",
        seconds, "pictures", pictures, "blocks", blocks);
    free(program);
    free(command);
    if (!found)
        report_fail("no memory");
    return found;
}

int report_make(report_run *run)
{
    double started = progress_clock();
    if (!gather(run))
        return 1;
    if (instructions_counting())
        return 0;
    double seconds = progress_clock() - started;
    json_t *found = document(run, seconds);
    bool written = found && json_write_file(json_incref(found), run->json, stderr) &&
                   write_page(run->page, found);
    json_decref(found);
    if (!written)
        return 1;
    if (!run->quiet)
        printf("%s: %d %s, %.0f s\n", run->page, run->count,
               run->count == 1 ? "routine" : "routines", seconds);
    return is_all_asked(run) ? 0 : 1;
}
