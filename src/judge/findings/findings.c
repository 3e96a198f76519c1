/* SPDX-License-Identifier: MIT */
#include "findings.h"

#include "../referee/referee_report.h"

#include "../../support/json_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The first fault of these that there is, NULL for none. */
static const example *first_of(const verdict *sum, int first, int end)
{
    for (int i = first; i < end; i++) {
        if (sum->faulty[i].found)
            return &sum->faulty[i];
    }
    return NULL;
}

static const example *example_of_decision(const judging_row *row)
{
    const refereed *by = &row->looked_at;
    const example *widest = NULL;
    double most = 0;
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++) {
        if (by->most[i] > most) {
            most = by->most[i];
            widest = &by->widest[i];
        }
    }
    widest = widest ? widest : first_of(&row->sum, 0, FAULTS_OF_DECISION);
    return widest ? widest : first_of(&row->sum, FAULTS_ANSWERED, FAULTS);
}

static const example *example_against(const judging_row *row, promise_kind kind)
{
    const verdict *sum = &row->sum;
    switch (kind) {
    case PROMISE_DECISIONS: return example_of_decision(row);
    case PROMISE_CONTRACT: return first_of(sum, FAULTS_OF_DECISION, FAULTS);
    case PROMISE_T_ULPS:
    case PROMISE_T_RELATIVE: return sum->worst_t.found ? &sum->worst_t : first_of(sum, 0, FAULTS);
    default: return sum->worst_normal.found ? &sum->worst_normal : first_of(sum, 0, FAULTS);
    }
}

bool findings_promised(const judging_plan *plan, const findings *of, int number, promised_row *one)
{
    const promises *all = &plan->required;
    if (number >= all->count * of->row_count)
        return false;
    const promise *held = &all->list[number / of->row_count];
    one->row = &of->rows[number % of->row_count];
    promise_print(held, one->promised);
    one->kept = promise_kept(held, &one->row->sum, &one->row->looked_at, &plan->told, &one->is);
    const error_summary *errors = promise_errors(held, &one->row->sum);
    one->none = errors ? errors->count == 0 : one->row->sum.cases == 0;
    one->shown = one->kept ? NULL : example_against(one->row, held->kind);
    return true;
}

json_t *judging_errors(const error_summary *of)
{
    return json_pack("{s:I, s:I, s:o, s:o, s:o, s:o}", "hits", (json_int_t)of->count,
                     "correctly_rounded", (json_int_t)of->right, "median",
                     json_measured(of->median), "99", json_measured(of->q99), "99.99",
                     json_measured(of->q9999), "most", json_measured(of->most));
}

json_t *judging_time(double time)
{
    return json_measured(time > 0 ? time : INFINITY);
}

static json_t *times_json(const judging_times *of)
{
    return json_pack("{s:o, s:o, s:o, s:o*}", "candidate", judging_time(of->candidate), "textbook",
                     judging_time(of->textbook), "certain", judging_time(of->certain), "building",
                     of->building > 0 ? json_measured(of->building) : NULL);
}

static json_t *row_json(const judging_row *row, const margins *told)
{
    const verdict *sum = &row->sum;
    return json_pack(
        "{s:s, s:s, s:s, s:I, s:I, s:I, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, "
        "s:o, s:o, s:o, s:o, s:o*, s:o}",
        "shape", sure_shape_name(row->shape), "query", query_names[row->asks], "regime",
        judging_row_name(row->which), "cases", (json_int_t)sum->cases, "valid",
        (json_int_t)sum->valid, "hits", (json_int_t)sum->hits, "skipped", (json_int_t)sum->skipped,
        "unasked", (json_int_t)sum->unasked, "wrong", (json_int_t)sum->wrong, "wrong_from",
        json_measured(sum->wrong_share.lower), "wrong_to", json_measured(sum->wrong_share.upper),
        "faults", json_named_counts(fault_name, sum->faults, FAULTS), "t_ulps",
        judging_errors(&sum->t_ulps), "t_relative", judging_errors(&sum->t_relative), "t_extents",
        judging_errors(&sum->t_extents), "t_pixels", judging_errors(&sum->t_pixels), "normal_ulps",
        judging_errors(&sum->normal_ulps), "normal", judging_errors(&sum->normal),
        "t_ulps_by_powers_of_two", json_counts(sum->t_classes, SIZE_CLASSES), "nanoseconds",
        times_json(&row->times), "instructions", times_json(&row->instructions), "margins",
        referee_margins(told, &row->looked_at), "decisions", referee_events(&row->looked_at));
}

json_t *worst_json(const worst_case *one)
{
    const example_lines lines = example_lines_of(&one->found);
    json_t *ulps =
        one->kind < FAULTS ? NULL : json_measured(worst_size(one->kind, &one->found, one->in));
    json_t *margin = one->margin > 0 ? json_measured(one->margin) : NULL;
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:o*, s:o*, s:s*}", "kind",
                     worst_name(one->kind), "shape", sure_shape_name(one->shape), "query",
                     query_names[one->asks], "regime", judging_row_name(one->which), "case",
                     lines.question, "answer", lines.given, "right", lines.right, "ulps", ulps,
                     "margin", margin, "event", worst_event(one));
}

static json_t *promise_json(const promise *one, bool kept)
{
    char line[CASE_LINE_MAX];
    promise_print(one, line);
    return json_pack("{s:s, s:b}", "promise", line, "kept", kept);
}

static json_t *convention_json(const convention_words *said)
{
    json_t *all = json_object();
    for (int i = 0; i < CONVENTIONS; i++) {
        if (*said->candidate[i])
            json_object_set_new(
                all, convention_name((convention)i),
                json_pack("{s:s, s:s}", "says", said->candidate[i], "contract", said->contract[i]));
    }
    return all;
}

static json_t *conventions_json(const findings *of)
{
    json_t *all = json_object();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (of->has_said[shape])
            json_object_set_new(all, sure_shape_name((sure_shape)shape),
                                convention_json(&of->said[shape]));
    }
    return all;
}

static json_t *words_json(const char *words)
{
    return *words ? json_text(words) : json_null();
}

json_t *identity_json(const identity *who)
{
    return json_pack("{s:o, s:o, s:o}", "name", words_json(who->name), "version",
                     words_json(who->version), "build", words_json(who->build));
}

static json_t *set_json(const case_set *set)
{
    return set ? json_pack("{s:s, s:s}", "name", set->name, "sha256", set->sha256) : json_null();
}

json_t *findings_json(const judging_plan *plan, const findings *of)
{
    const promises *all = &plan->required;
    json_t *rows = json_array(), *worst = json_array(), *required = json_array();
    json_t *found = identity_json(&of->who);
    for (int i = 0; i < of->row_count; i++)
        json_array_append_new(rows, row_json(&of->rows[i], &plan->told));
    for (int i = 0; i < of->worst_count; i++)
        json_array_append_new(worst, worst_json(&of->worst[i]));
    for (int i = 0; i < all->count; i++)
        json_array_append_new(required, promise_json(&all->list[i], of->kept[i]));
    json_t *rest = json_pack(
        "{s:o, s:s, s:s, s:s, s:I, s:I, s:o, s:b, s:o, s:o, s:o, s:o}", "candidate",
        json_text(plan->name), "judge", plan->surehit.version, "judge_build", plan->surehit.build,
        "truth", plan->by_reference ? "reference" : "exact", "seed", (json_int_t)plan->seed,
        "count", plan->cases ? (json_int_t)0 : (json_int_t)plan->count, "set",
        set_json(plan->rows.set), "time_includes_text", plan->subject == SUBJECT_COMMAND, "rows",
        rows, "conventions", conventions_json(of), "worst", worst, "required", required);
    if (json_object_update_new(found, rest) == 0)
        return found;
    json_decref(found);
    return NULL;
}
