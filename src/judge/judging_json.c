/* The report as JSON: one object; a number that is infinite or unknown is null. */
#include "judging_report.h"

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

/* Element n > 0: ulps above 2^(n - 2), up to 2^(n - 1); element 0: none. */
static json_t *classes_json(const uint64_t classes[SIZE_CLASSES])
{
    json_t *array = json_array();
    for (int i = 0; i < SIZE_CLASSES; i++)
        json_array_append_new(array, count_json(classes[i]));
    return array;
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

static json_t *times_json(const judging_times *times)
{
    return json_pack("{s:o, s:o, s:o}", "candidate", time_json(times->candidate), "textbook",
                     time_json(times->textbook), "certain", time_json(times->certain));
}

static json_t *row_json(const judging_row *row)
{
    const verdict *sum = &row->sum;
    json_t *object = json_pack(
        "{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "shape", sure_shape_name(row->shape),
        "regime", judging_row_name(row), "cases", count_json(sum->cases), "valid",
        count_json(sum->valid), "hits", count_json(sum->hits), "skipped", count_json(sum->skipped),
        "unasked", count_json(sum->unasked), "wrong", count_json(sum->wrong), "wrong_from",
        json_measured(sum->wrong_share.lower), "wrong_to", json_measured(sum->wrong_share.upper));
    json_object_set_new(object, "faults", faults_json(sum));
    json_object_set_new(object, "t_ulps", errors_json(&sum->t_ulps));
    json_object_set_new(object, "t_relative", errors_json(&sum->t_relative));
    json_object_set_new(object, "normal_ulps", errors_json(&sum->normal_ulps));
    json_object_set_new(object, "normal", errors_json(&sum->normal));
    json_object_set_new(object, "t_ulps_by_powers_of_two", classes_json(sum->t_classes));
    json_object_set_new(object, "nanoseconds", times_json(&row->times));
    return object;
}

static json_t *worst_json(const worst_case *one)
{
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
    judging_row met = {.which = one->which};
    case_print(&one->found.question, question);
    reply_print(&one->found.given, given);
    case_answer_print(&one->found.truth, right);
    json_t *object =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:s}", "kind", worst_name(one->kind), "shape",
                  sure_shape_name(one->shape), "regime", judging_row_name(&met), "case", question,
                  "answer", given, "right", right);
    if (one->kind >= FAULTS)
        json_object_set_new(object, "ulps",
                            json_measured(worst_size(one->kind, &one->found, one->in)));
    return object;
}

static json_t *promise_json(const promise *one, const judging_row *rows, int count)
{
    char line[CASE_LINE_MAX];
    double is;
    bool kept = true;
    for (int i = 0; i < count; i++)
        kept = promise_kept(one, &rows[i].sum, &is) && kept;
    promise_print(one, line);
    return json_pack("{s:s, s:b}", "promise", line, "kept", kept);
}

json_t *judging_json(const judging_subject *subject, const judging_row *rows, int row_count,
                     const worst_case *list, int list_count, const promises *all)
{
    json_t *judged = json_array(), *worst = json_array(), *required = json_array();
    for (int i = 0; i < row_count; i++)
        json_array_append_new(judged, row_json(&rows[i]));
    for (int i = 0; i < list_count; i++)
        json_array_append_new(worst, worst_json(&list[i]));
    for (int i = 0; i < all->count; i++)
        json_array_append_new(required, promise_json(&all->list[i], rows, row_count));
    return json_pack("{s:s, s:s, s:o, s:o, s:b, s:o, s:o, s:o}", "candidate", subject->candidate,
                     "truth", subject->truth, "seed", count_json(subject->seed), "count",
                     count_json(subject->count), "time_includes_text", subject->counts_text, "rows",
                     judged, "worst", worst, "required", required);
}
