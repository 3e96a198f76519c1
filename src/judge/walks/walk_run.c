/* SPDX-License-Identifier: MIT */
#include "walk.h"

#include "../../numbers/digits/hex_float.h"
#include "../../support/json_file.h"
#include "../../support/printable.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

static const char *name_of(const walk_plan *plan)
{
    return plan->library ? plan->library : sure_tier_name(plan->by.tier);
}

static uint64_t sum_of_faults(const walk_sum *sum)
{
    uint64_t all = 0;
    for (int i = 0; i < WALK_FAULTS; i++)
        all += sum->faults[i];
    return all;
}

static void print_head(const walk_plan *plan)
{
    printable_print(stdout, name_of(plan));
    printf(", held against %s: %" PRIu64 " steps a row, seed %" PRIu64 ", started again ",
           plan->by_reference ? "reference" : "exact", plan->steps, plan->seed);
    if (isnan(plan->by.nudge))
        puts("where sure_spawn tells");
    else
        printf("%g behind the answer\n", plan->by.nudge);
    printf("\n%-9s %-8s %11s %10s", "shape", "kind", "steps", "walks");
    for (int i = 0; i < WALK_FAULTS; i++)
        printf(" %9s", walk_fault_name(i));
    puts(" | per million |  stopped");
}

static void print_counts(const char *shape, const char *kind, const walk_sum *sum)
{
    printf("%-9s %-8s %11" PRIu64 " %10" PRIu64, shape, kind, sum->steps, sum->walks);
    for (int i = 0; i < WALK_FAULTS; i++)
        printf(" %9" PRIu64, sum->faults[i]);
    if (sum->steps > 0)
        printf(" | %11.6g", 1e6 * (double)sum_of_faults(sum) / (double)sum->steps);
    else
        printf(" | %11s", "-");
    printf(" | %8" PRIu64 "\n", sum->stopped);
    fflush(stdout);
}

/* What the routine was asked, a case line a solid. */
static void print_question(const walk_step *step, int solid, char line[CASE_LINE_MAX])
{
    const sure_case asked = {.ray = step->ray, .object = step->in.solids[solid]};
    case_print(&asked, line);
}

/* "": nothing was met. */
static void print_start(const walk_step *step, char line[CASE_LINE_MAX])
{
    line[0] = '\0';
    if (step->met >= 0)
        snprintf(line, CASE_LINE_MAX, "%s %s %s", HEX(step->start.x), HEX(step->start.y),
                 HEX(step->start.z));
}

/* The first steps that led to each fault. */
static void print_steps(const walk_sum *sum)
{
    char line[CASE_LINE_MAX];
    for (int i = 0; i < WALK_FAULTS; i++) {
        const walk_step *step = &sum->first[i];
        if (sum->faults[i] == 0)
            continue;
        printf("\n%s\n", walk_fault_name(i));
        for (int k = 0; k < step->in.count; k++) {
            print_question(step, k, line);
            printf("  %s%s\n", line, k == step->met ? " (met)" : "");
        }
        print_start(step, line);
        if (line[0] != '\0')
            printf("  next start %s\n", line);
    }
}

static json_t *step_json(const walk_step *step)
{
    char line[CASE_LINE_MAX];
    json_t *asked = json_array();
    for (int i = 0; i < step->in.count; i++) {
        print_question(step, i, line);
        json_array_append_new(asked, json_string(line));
    }
    print_start(step, line);
    return json_pack("{s:o, s:i, s:s}", "asked", asked, "met", step->met, "start", line);
}

static json_t *counts_json(const walk_sum *sum)
{
    json_t *first = json_object();
    for (int i = 0; i < WALK_FAULTS; i++) {
        if (sum->faults[i] > 0)
            json_object_set_new(first, walk_fault_name(i), step_json(&sum->first[i]));
    }
    return json_pack("{s:I, s:I, s:I, s:o, s:o}", "steps", (json_int_t)sum->steps, "walks",
                     (json_int_t)sum->walks, "stopped", (json_int_t)sum->stopped, "faults",
                     json_named_counts(walk_fault_name, sum->faults, WALK_FAULTS), "first", first);
}

static json_t *plan_json(const walk_plan *plan, json_t *rows, const walk_sum *all)
{
    return json_pack("{s:s, s:o, s:o, s:s, s:I, s:I, s:o, s:o}", "program", "surehit walk",
                     "routine", json_text(name_of(plan)), "nudge",
                     isnan(plan->by.nudge) ? json_null() : json_real(plan->by.nudge), "truth",
                     plan->by_reference ? "reference" : "exact", "steps", (json_int_t)plan->steps,
                     "seed", (json_int_t)plan->seed, "rows", rows, "all", counts_json(all));
}

/* Is the row asked for, can it be walked, and does the routine answer it? */
static bool has_row(const walk_plan *plan, int shape, int kind)
{
    bool any = true;
    for (int i = 0; i < WALK_KINDS; i++)
        any = any && !plan->kinds[i];
    return walk_kind_applies((sure_shape)shape, (walk_kind)kind) && (any || plan->kinds[kind]) &&
           (!plan->rows.some_shapes || plan->rows.shapes[shape]) &&
           (!plan->by.asked || plan->by.asked->answers[QUERY_HIT][shape]);
}

static bool walk_rows(const walk_plan *plan, truth *known, json_t *rows, walk_sum *all,
                      char *message)
{
    for (int row = 0; row < SURE_SHAPES * WALK_KINDS; row++) {
        int shape = row / WALK_KINDS, kind = row % WALK_KINDS;
        walk_sum sum;
        if (!has_row(plan, shape, kind))
            continue;
        if (!walk_steps(plan, known, (sure_shape)shape, (walk_kind)kind, &sum, message))
            return false;
        progress_finish(plan->bar);
        print_counts(sure_shape_name((sure_shape)shape), walk_kind_names[kind], &sum);
        walk_add(all, &sum);
        json_t *counts = counts_json(&sum);
        json_object_set_new(counts, "shape", json_string(sure_shape_name((sure_shape)shape)));
        json_object_set_new(counts, "kind", json_string(walk_kind_names[kind]));
        json_array_append_new(rows, counts);
    }
    return true;
}

static int count_rows(const walk_plan *plan, char *message)
{
    int count = 0;
    for (int row = 0; row < SURE_SHAPES * WALK_KINDS; row++)
        count += has_row(plan, row / WALK_KINDS, row % WALK_KINDS);
    if (count > 0)
        return count;
    return complain(message, "no kind of walk in a solid that it answers");
}

static int walk_with(const walk_plan *plan, truth *known, char *message)
{
    walk_sum all = {0};
    json_t *rows = json_array();
    print_head(plan);
    if (!walk_rows(plan, known, rows, &all, message)) {
        json_decref(rows);
        fprintf(stderr, "surehit walk: error: %s\n", message);
        return 2;
    }
    print_counts("all", "", &all);
    print_steps(&all);
    if (all.steps == 0) {
        json_decref(rows);
        fputs("surehit walk: error: no step could be asked\n", stderr);
        return 2;
    }
    if (!json_write_file(plan_json(plan, rows, &all), plan->json, stderr))
        return 1;
    return plan->required && sum_of_faults(&all) > 0;
}

/* Its answers are held against solids, and go on from its t. */
static bool can_walk(const candidate *by, char *message)
{
    const char *word = by->entry.wall ? "wall" : by->entry.decision ? "decision" : NULL;
    return !word || complain(message, "a routine of the entry '%s' can't walk", word);
}

int walk_run(const walk_plan *plan)
{
    static truth known;
    char message[CANDIDATE_MESSAGE];
    walk_plan with = *plan;
    int status = 2;
    bool ready = !plan->by_reference || truth_reference(plan->how.time_limit, &known, message);
    if (ready && plan->library) {
        with.by.asked = candidate_of_library(plan->library, &plan->how, message);
        ready = with.by.asked && can_walk(with.by.asked, message);
    }
    int rows = ready ? count_rows(&with, message) : 0;
    progress bar = progress_start(stderr, progress_total(rows, plan->steps));
    with.bar = &bar;
    if (rows > 0)
        status = walk_with(&with, &known, message);
    else
        fprintf(stderr, "surehit walk: error: %s\n", message);
    progress_finish(&bar);
    candidate_close(with.by.asked);
    truth_close(&known);
    return status;
}
