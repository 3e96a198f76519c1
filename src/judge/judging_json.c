/* The report as JSON: one object; a number that is infinite or unknown is null. */
#include "judging_run.h"

#include "../support/json_file.h"

#include <math.h>

static json_t *count_json(uint64_t count)
{
    return json_integer((json_int_t)count);
}

static json_t *errors_json(const error_summary *of)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "hits", count_json(of->count),
                     "correctly_rounded", count_json(of->right), "median",
                     json_measured(of->median), "99", json_measured(of->q99), "99.99",
                     json_measured(of->q9999), "most", json_measured(of->most));
}

static json_t *faults_json(const verdict *sum)
{
    json_t *object = json_object();
    for (int i = 0; i < FAULTS; i++)
        json_object_set_new(object, fault_name((fault)i), count_json(sum->faults[i]));
    return object;
}

static json_t *time_json(double nanoseconds)
{
    return json_measured(nanoseconds > 0 ? nanoseconds : INFINITY);
}

static json_t *row_json(const judging_row *row)
{
    const verdict *sum = &row->sum;
    const judging_times *times = &row->times;
    return json_pack(
        "{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, "
        "s:{s:o, s:o, s:o}}",
        "shape", sure_shape_name(row->shape), "regime", judging_row_name(row->which), "cases",
        count_json(sum->cases), "valid", count_json(sum->valid), "hits", count_json(sum->hits),
        "skipped", count_json(sum->skipped), "unasked", count_json(sum->unasked), "wrong",
        count_json(sum->wrong), "wrong_from", json_measured(sum->wrong_share.lower), "wrong_to",
        json_measured(sum->wrong_share.upper), "faults", faults_json(sum), "t_ulps",
        errors_json(&sum->t_ulps), "t_relative", errors_json(&sum->t_relative), "normal_ulps",
        errors_json(&sum->normal_ulps), "normal", errors_json(&sum->normal),
        "t_ulps_by_powers_of_two", json_counts(sum->t_classes, SIZE_CLASSES), "nanoseconds",
        "candidate", time_json(times->candidate), "textbook", time_json(times->textbook), "certain",
        time_json(times->certain));
}

static json_t *worst_json(const worst_case *one)
{
    const worst_lines lines = worst_lines_of(one);
    json_t *ulps =
        one->kind < FAULTS ? NULL : json_measured(worst_size(one->kind, &one->found, one->in));
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:o*}", "kind", worst_name(one->kind), "shape",
                     sure_shape_name(one->shape), "regime", judging_row_name(one->which), "case",
                     lines.question, "answer", lines.given, "right", lines.right, "ulps", ulps);
}

static json_t *promise_json(const promise *one, const judging_findings *of)
{
    char line[CASE_LINE_MAX];
    double is;
    bool kept = true;
    for (int i = 0; i < of->row_count; i++)
        kept = promise_kept(one, &of->rows[i].sum, &is) && kept;
    promise_print(one, line);
    return json_pack("{s:s, s:b}", "promise", line, "kept", kept);
}

json_t *judging_json(const judging_plan *plan, const judging_findings *of)
{
    const promises *all = &plan->required;
    json_t *rows = json_array(), *worst = json_array(), *required = json_array();
    for (int i = 0; i < of->row_count; i++)
        json_array_append_new(rows, row_json(&of->rows[i]));
    for (int i = 0; i < of->worst_count; i++)
        json_array_append_new(worst, worst_json(&of->worst[i]));
    for (int i = 0; i < all->count; i++)
        json_array_append_new(required, promise_json(&all->list[i], of));
    return json_pack("{s:s, s:s, s:I, s:I, s:b, s:o, s:o, s:o}", "candidate", plan->name, "truth",
                     plan->by_reference ? "reference" : "exact", "seed", (json_int_t)plan->seed,
                     "count", plan->cases ? (json_int_t)0 : (json_int_t)plan->count,
                     "time_includes_text", plan->subject == SUBJECT_COMMAND, "rows", rows, "worst",
                     worst, "required", required);
}
