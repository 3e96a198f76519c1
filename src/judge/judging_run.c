#include "judging.h"

#include "bench/instructions.h"

#include "referee/referee_report.h"

#include "../support/json_file.h"
#include "../support/shell.h"

#include <inttypes.h>
#include <math.h>

/* What was found. */
typedef struct {
    uint64_t left_out; /* lines of cases */
    judging_row rows[SURE_SHAPES * REGIMES];
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
    bool kept[PROMISES_MOST];
} findings;

static void print_head(const judging_plan *plan)
{
    bool is_tier = plan->subject == SUBJECT_TIER;
    printf("%s, held against %s", plan->name, plan->by_reference ? "reference" : "exact");
    if (is_tier && plan->tier >= SURE_TIER_CERTAIN && !plan->by_reference)
        fputs(" (no independent evidence; --truth reference is)", stdout);
    if (!plan->cases)
        printf(": %" PRIu64 " cases a row, seed %" PRIu64, plan->count, plan->seed);
    printf("\n"
           "Wrong: decisions, in %% of the valid cases, with a 95 %% interval. t: of hits rightly\n"
           "found, in ulps: not exceeded by so many; correctly rounded. ns: a ray%s,\n"
           "beside textbook and certain on the same cases%s.\n%s\n",
           plan->subject == SUBJECT_COMMAND ? ", lines read and written included" : "",
           is_tier ? ", all without normals" : ", with normals if it gives them",
           plan->instructions ? "instr: instructions a ray of the first cases, likewise.\n" : "");
    printf("%-9s %-13s %7s %-17s %7s %7s %7s | %8s %8s %8s %8s %6s | %8s %6s | %6s %5s %5s%s\n",
           "shape", "regime", "wrong %", " from .. to", "f. hit", "f. miss", "part", "t: 50 %",
           "99 %", "99.99 %", "most", "right%", "n: most", "right%", "ns", "textb", "cert",
           plan->instructions ? " |  instr textb  cert" : "");
}

static void print_share(const verdict *sum)
{
    char interval[32];
    double share = sum->valid > 0 ? 100 * (double)sum->wrong / (double)sum->valid : 0;
    snprintf(interval, sizeof interval, "%.3g .. %.3g", 100 * sum->wrong_share.lower,
             100 * sum->wrong_share.upper);
    int digits = sum->wrong == 0 ? 0 : share < 1 ? 4 : 2;
    printf(" %7.*f %-17s", digits, share, sum->valid > 0 ? interval : "");
}

/* Whole where it is small and whole; `none` where there is nothing. */
static void print_size(const error_summary *of, double size, const char *none)
{
    if (of->count == 0)
        printf(" %8s", none);
    else if (size < 1000 && size == floor(size))
        printf(" %8.0f", size);
    else
        printf(" %8.2e", size);
}

static void print_sizes(const error_summary *of, const char *none)
{
    print_size(of, of->median, none);
    print_size(of, of->q99, none);
    print_size(of, of->q9999, none);
    print_size(of, of->most, none);
}

static void print_right(const error_summary *of)
{
    double share = 100 * (double)of->right / (double)of->count;
    if (of->count == 0)
        printf(" %6s", "");
    else if (of->right < of->count && share > 99.99) /* 100 is all of them */
        printf(" %6s", ">99.99");
    else
        printf(" %6.*f", of->right == of->count ? 0 : 2, share);
}

static void print_times(const judging_times *of)
{
    if (of->candidate > 0)
        printf(" | %6.0f %5.0f %5.0f", of->candidate, of->textbook, of->certain);
}

static void print_row(const judging_row *row)
{
    const verdict *sum = &row->sum;
    printf("%-9s %-13s", sure_shape_name(row->shape), judging_row_name(row->which));
    print_share(sum);
    printf(" %7" PRIu64 " %7" PRIu64 " %7" PRIu64, sum->faults[FAULT_FALSE_HIT],
           sum->faults[FAULT_FALSE_MISS], sum->faults[FAULT_WRONG_PART]);
    const error_summary *t = &sum->t_ulps, *n = &sum->normal_ulps;
    fputs(" |", stdout);
    print_sizes(t, "");
    print_right(t);
    fputs(" |", stdout);
    print_size(n, n->most, "");
    print_right(n);
    print_times(&row->times);
    print_times(&row->instructions);
    putchar('\n');
    fflush(stdout);
}

static void finish_row(judging_row *row)
{
    row->instructions.candidate = instructions_figure(row->times.candidate);
    row->instructions.textbook = instructions_figure(row->times.textbook);
    row->instructions.certain = instructions_figure(row->times.certain);
    print_row(row);
}

/* Cases that are given have no picture. */
static void print_lengths(const findings *of)
{
    const char *head =
        "\nErrors of t as lengths, in pictures (camera): over the scene's size; in pixels,\n"
        "over what one of them covers at the hit.\n\n"
        "shape   size 50 %     99 %  99.99 %     most pix 50 %     99 %  99.99 %     most\n";
    for (int i = 0; i < of->row_count; i++) {
        const judging_row *row = &of->rows[i];
        if (row->which != REGIME_CAMERA && row->which != JUDGING_GIVEN)
            continue;
        printf("%s%-8s", head, sure_shape_name(row->shape));
        print_sizes(&row->sum.t_extents, "-");
        print_sizes(&row->sum.t_pixels, "-");
        putchar('\n');
        head = "";
    }
}

static void print_margins(const judging_plan *plan, const candidate *asked, const findings *of)
{
    bool any = false;
    for (int i = 0; i < of->row_count; i++) {
        const judging_row *row = &of->rows[i];
        const referee_row at = {sure_shape_name(row->shape), judging_row_name(row->which),
                                &row->sum, &row->looked_at};
        any = referee_print(&at, &plan->told, &asked->entry, any) || any;
    }
    if (of->left_out > 0)
        printf("\nCase lines of other shapes, left out: %" PRIu64 "\n", of->left_out);
}

static void print_breaches_of(const judging_row *row)
{
    const verdict *sum = &row->sum;
    const char *before = ": ";
    if (verdict_breaches(sum) + sum->faults[FAULT_REFUSED] + sum->skipped + sum->unasked == 0)
        return;
    printf("  %s %s", sure_shape_name(row->shape), judging_row_name(row->which));
    for (int i = FAULT_REFUSED; i < FAULTS; i++) {
        if (sum->faults[i] == 0)
            continue;
        printf("%s%s %" PRIu64, before, fault_name((fault)i), sum->faults[i]);
        before = ", ";
    }
    if (sum->skipped > 0)
        printf("%sskipped, for floats make them invalid %" PRIu64, before, sum->skipped);
    before = sum->skipped > 0 ? ", " : before;
    if (sum->unasked > 0)
        printf("%sgiven up, not asked %" PRIu64, before, sum->unasked);
    putchar('\n');
}

static void print_breaches(const findings *of)
{
    uint64_t sum = 0;
    for (int i = 0; i < of->row_count; i++)
        sum += verdict_breaches(&of->rows[i].sum) + of->rows[i].sum.unasked;
    printf("\nBreaches of the contract: %" PRIu64 "\n", sum);
    for (int i = 0; i < of->row_count; i++)
        print_breaches_of(&of->rows[i]);
}

/* How the candidate is named on a command line. */
static void print_option(const judging_plan *plan)
{
    static const char *const forms[] = {
        [SUBJECT_TIER] = " --tier ",
        [SUBJECT_LIBRARY] = " --candidate ",
        [SUBJECT_COMMAND] = " --command ",
    };
    fputs(forms[plan->subject], stdout);
    shell_print(stdout, plan->name);
    fputs(plan->how.inputs == INPUTS_FLOAT ? " --inputs float" : "", stdout);
    fputs(plan->by_reference ? " --truth reference\n" : "\n", stdout);
}

static const char *worst_name(int kind)
{
    return kind == WORST_T        ? "largest error of t"
           : kind == WORST_NORMAL ? "largest error of the normal"
                                  : fault_name((fault)kind);
}

/* The case, what the candidate said and what is right, as text. */
typedef struct {
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
} worst_lines;

static worst_lines worst_lines_of(const worst_case *one)
{
    worst_lines lines;
    case_print(&one->found.question, lines.question);
    reply_print(&one->found.given, lines.given);
    case_answer_print(&one->found.truth, lines.right);
    return lines;
}

static void print_worst_case(const judging_plan *plan, const worst_case *one)
{
    const worst_lines lines = worst_lines_of(one);
    printf("\n%s (%s %s)", worst_name(one->kind), sure_shape_name(one->shape),
           judging_row_name(one->which));
    if (one->kind >= FAULTS)
        printf(", %.6g ulps", worst_size(one->kind, &one->found, one->in));
    else if (one->margin > 0)
        printf(", wrong by %.3g %s", one->margin, referee_unit_words(plan->told.unit));
    printf("\n  answer  %s\n  right   %s\n", lines.given, lines.right);
    if (plan->subject == SUBJECT_ANSWERS) { /* who can't be asked again */
        printf("  case    %s\n", lines.question);
        return;
    }
    printf("  echo '%s' | ", lines.question);
    shell_print_program(stdout);
    fputs(" judge --cases -", stdout);
    print_option(plan);
}

static void print_worst(const judging_plan *plan, const findings *of)
{
    if (of->worst_count > 0)
        fputs("\nWorst cases, one of each kind, made simple\n", stdout);
    for (int i = 0; i < of->worst_count; i++)
        print_worst_case(plan, &of->worst[i]);
}

/* How many are broken; which are kept. */
static int print_promises(const promises *all, const margins *told, findings *of)
{
    int broken = 0;
    if (all->count > 0)
        fputs("\nRequired\n", stdout);
    for (int n = 0; n < all->count; n++) {
        char line[CASE_LINE_MAX];
        bool kept = true;
        double is;
        promise_print(&all->list[n], line);
        for (int i = 0; i < of->row_count; i++) {
            const judging_row *row = &of->rows[i];
            if (promise_kept(&all->list[n], &row->sum, &row->looked_at, told, &is))
                continue;
            printf("  BROKEN  %s: %s %s: %.6g\n", line, sure_shape_name(row->shape),
                   judging_row_name(row->which), is);
            kept = false;
        }
        if (kept)
            printf("  kept    %s\n", line);
        broken += !kept;
        of->kept[n] = kept;
    }
    return broken;
}

/* JSON. */

static json_t *count_json(uint64_t count)
{
    return json_integer((json_int_t)count);
}

json_t *judging_errors(const error_summary *of)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "hits", count_json(of->count),
                     "correctly_rounded", count_json(of->right), "median",
                     json_measured(of->median), "99", json_measured(of->q99), "99.99",
                     json_measured(of->q9999), "most", json_measured(of->most));
}

static const char *name_of_fault(int i)
{
    return fault_name((fault)i);
}

json_t *judging_time(double time)
{
    return json_measured(time > 0 ? time : INFINITY);
}

static json_t *times_json(const judging_times *of)
{
    return json_pack("{s:o, s:o, s:o}", "candidate", judging_time(of->candidate), "textbook",
                     judging_time(of->textbook), "certain", judging_time(of->certain));
}

static json_t *row_json(const judging_row *row, const margins *told)
{
    const verdict *sum = &row->sum;
    return json_pack(
        "{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, "
        "s:o, s:o, s:o, s:o, s:o*, s:o}",
        "shape", sure_shape_name(row->shape), "regime", judging_row_name(row->which), "cases",
        count_json(sum->cases), "valid", count_json(sum->valid), "hits", count_json(sum->hits),
        "skipped", count_json(sum->skipped), "unasked", count_json(sum->unasked), "wrong",
        count_json(sum->wrong), "wrong_from", json_measured(sum->wrong_share.lower), "wrong_to",
        json_measured(sum->wrong_share.upper), "faults",
        json_named_counts(name_of_fault, sum->faults, FAULTS), "t_ulps",
        judging_errors(&sum->t_ulps), "t_relative", judging_errors(&sum->t_relative), "t_extents",
        judging_errors(&sum->t_extents), "t_pixels", judging_errors(&sum->t_pixels), "normal_ulps",
        judging_errors(&sum->normal_ulps), "normal", judging_errors(&sum->normal),
        "t_ulps_by_powers_of_two", json_counts(sum->t_classes, SIZE_CLASSES), "nanoseconds",
        times_json(&row->times), "instructions", times_json(&row->instructions), "margins",
        referee_margins(told, &row->looked_at), "conventions", referee_events(&row->looked_at));
}

static json_t *worst_json(const worst_case *one)
{
    const worst_lines lines = worst_lines_of(one);
    json_t *ulps =
        one->kind < FAULTS ? NULL : json_measured(worst_size(one->kind, &one->found, one->in));
    json_t *margin = one->margin > 0 ? json_measured(one->margin) : NULL;
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:o*, s:o*}", "kind", worst_name(one->kind),
                     "shape", sure_shape_name(one->shape), "regime", judging_row_name(one->which),
                     "case", lines.question, "answer", lines.given, "right", lines.right, "ulps",
                     ulps, "margin", margin);
}

static json_t *promise_json(const promise *one, bool kept)
{
    char line[CASE_LINE_MAX];
    promise_print(one, line);
    return json_pack("{s:s, s:b}", "promise", line, "kept", kept);
}

/* A number that is infinite or unknown is null; NULL when there is no memory. */
static json_t *json_of(const judging_plan *plan, const findings *of)
{
    const promises *all = &plan->required;
    json_t *rows = json_array(), *worst = json_array(), *required = json_array();
    for (int i = 0; i < of->row_count; i++)
        json_array_append_new(rows, row_json(&of->rows[i], &plan->told));
    for (int i = 0; i < of->worst_count; i++)
        json_array_append_new(worst, worst_json(&of->worst[i]));
    for (int i = 0; i < all->count; i++)
        json_array_append_new(required, promise_json(&all->list[i], of->kept[i]));
    return json_pack("{s:s, s:s, s:I, s:I, s:b, s:o, s:o, s:o}", "candidate", plan->name, "truth",
                     plan->by_reference ? "reference" : "exact", "seed", (json_int_t)plan->seed,
                     "count", plan->cases ? (json_int_t)0 : (json_int_t)plan->count,
                     "time_includes_text", plan->subject == SUBJECT_COMMAND, "rows", rows, "worst",
                     worst, "required", required);
}

/* The run. */

static bool judge_made(const judging_plan *plan, judging *by, findings *all, char *message)
{
    const bool *answers = judging_asked(by)->answers;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!plan->rows.shapes[shape] || answers[shape])
            continue;
        return complain(message, "%s: no symbol sure_candidate_%s", plan->name,
                        sure_shape_name((sure_shape)shape));
    }
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        int shape = i / REGIMES, which = i % REGIMES;
        if (!regime_rows_have(&plan->rows, shape, which) || !answers[shape])
            continue;
        judging_row *row = &all->rows[all->row_count];
        if (!judging_regime(by, (sure_shape)shape, (regime)which, plan->count, row, message))
            return false;
        finish_row(row);
        all->row_count++;
    }
    return all->row_count > 0 || complain(message, "the shape has no such regime");
}

static bool judge_all(const judging_plan *plan, findings *all, char *message)
{
    judging *by = judging_open(plan, message);
    if (!by)
        return false;
    print_head(plan);
    bool done = plan->cases ? judging_given(by, all->rows, &all->row_count, &all->left_out, message)
                            : judge_made(plan, by, all, message);
    for (int i = 0; done && plan->cases && i < all->row_count; i++)
        finish_row(&all->rows[i]);
    done = done && judging_answers_end(by, message);
    if (done && !instructions_counting()) {
        print_lengths(all);
        print_margins(plan, judging_asked(by), all);
        print_breaches(all);
        fflush(stdout);
        all->worst_count = worst_find(by, all->rows, all->row_count, all->worst);
        print_worst(plan, all);
    }
    judging_close(by);
    return done;
}

int judging_run(const judging_plan *plan)
{
    static findings all;
    char message[CANDIDATE_MESSAGE];
    if (!judge_all(plan, &all, message)) {
        fprintf(stderr, "surehit judge: error: %s\n", message);
        return 2;
    }
    int broken = print_promises(&plan->required, &plan->told, &all);
    bool written = json_write_file(json_of(plan, &all), plan->json, stderr);
    return broken > 0 || !written;
}
