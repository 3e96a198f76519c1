#include "judging_run.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

void judging_print_head(FILE *out, const judging_plan *plan)
{
    bool is_tier = plan->subject == SUBJECT_TIER;
    fprintf(out, "%s, held against %s", plan->name, plan->by_reference ? "reference" : "exact");
    if (is_tier && plan->tier >= SURE_TIER_CERTAIN && !plan->by_reference)
        fputs(" (no independent evidence; --truth reference is)", out);
    if (!plan->cases)
        fprintf(out, ": %" PRIu64 " cases a row, seed %" PRIu64, plan->count, plan->seed);
    fprintf(
        out,
        "\n"
        "Wrong: decisions, in %% of the valid cases, with a 95 %% interval. t: of hits rightly\n"
        "found, in ulps: not exceeded by so many; correctly rounded. ns: a ray%s,\n"
        "beside textbook and certain on the same cases%s.\n\n",
        plan->subject == SUBJECT_COMMAND ? ", lines read and written included" : "",
        is_tier ? ", all without normals" : ", with normals if it gives them");
    fprintf(out, "%-9s %-13s %7s %-17s %7s %7s %7s | %8s %8s %8s %8s %6s | %8s %6s | %6s %5s %5s\n",
            "shape", "regime", "wrong %", " from .. to", "f. hit", "f. miss", "part", "t: 50 %",
            "99 %", "99.99 %", "most", "right%", "n: most", "right%", "ns", "textb", "cert");
}

static void print_share(FILE *out, const verdict *sum)
{
    char interval[32];
    double share = sum->valid > 0 ? 100 * (double)sum->wrong / (double)sum->valid : 0;
    snprintf(interval, sizeof interval, "%.3g .. %.3g", 100 * sum->wrong_share.lower,
             100 * sum->wrong_share.upper);
    fprintf(out, " %7.*f %-17s",
            sum->wrong == 0 ? 0
            : share < 1     ? 4
                            : 2,
            share, sum->valid > 0 ? interval : "");
}

/* Whole where it is small and whole. */
static void print_size(FILE *out, double size)
{
    if (size < 1000 && size == floor(size))
        fprintf(out, " %8.0f", size);
    else
        fprintf(out, " %8.2e", size);
}

static void print_right(FILE *out, const error_summary *of)
{
    double share = 100 * (double)of->right / (double)of->count;
    /* 100 is all of them. */
    if (of->right < of->count && share > 99.99)
        fprintf(out, " %6s", ">99.99");
    else
        fprintf(out, " %6.*f", of->right == of->count ? 0 : 2, share);
}

/* So many sizes, and what is correctly rounded; blank where there is nothing. */
static void print_errors(FILE *out, const error_summary *of, const double *sizes, int count)
{
    fputs(" |", out);
    for (int i = 0; i < count; i++) {
        if (of->count > 0)
            print_size(out, sizes[i]);
        else
            fprintf(out, " %8s", "");
    }
    if (of->count > 0)
        print_right(out, of);
    else
        fprintf(out, " %6s", "");
}

void judging_print_row(FILE *out, const judging_row *row)
{
    const verdict *sum = &row->sum;
    fprintf(out, "%-9s %-13s", sure_shape_name(row->shape), judging_row_name(row->which));
    print_share(out, sum);
    fprintf(out, " %7" PRIu64 " %7" PRIu64 " %7" PRIu64, sum->faults[FAULT_FALSE_HIT],
            sum->faults[FAULT_FALSE_MISS], sum->faults[FAULT_WRONG_PART]);
    const error_summary *t = &sum->t_ulps, *n = &sum->normal_ulps;
    print_errors(out, t, (double[]){t->median, t->q99, t->q9999, t->most}, 4);
    print_errors(out, n, &n->most, 1);
    if (row->times.candidate > 0)
        fprintf(out, " | %6.0f %5.0f %5.0f", row->times.candidate, row->times.textbook,
                row->times.certain);
    fputc('\n', out);
}

static void print_breaches_of(FILE *out, const judging_row *row)
{
    const verdict *sum = &row->sum;
    const char *before = ": ";
    if (verdict_breaches(sum) + sum->faults[FAULT_REFUSED] + sum->skipped + sum->unasked == 0)
        return;
    fprintf(out, "  %s %s", sure_shape_name(row->shape), judging_row_name(row->which));
    for (int i = FAULT_REFUSED; i < FAULTS; i++) {
        if (sum->faults[i] == 0)
            continue;
        fprintf(out, "%s%s %" PRIu64, before, fault_name((fault)i), sum->faults[i]);
        before = ", ";
    }
    if (sum->skipped > 0)
        fprintf(out, "%sskipped, for floats make them invalid %" PRIu64, before, sum->skipped);
    before = sum->skipped > 0 ? ", " : before;
    if (sum->unasked > 0)
        fprintf(out, "%sgiven up, not asked %" PRIu64, before, sum->unasked);
    fputc('\n', out);
}

void judging_print_breaches(FILE *out, const judging_findings *of)
{
    uint64_t sum = 0;
    for (int i = 0; i < of->row_count; i++)
        sum += verdict_breaches(&of->rows[i].sum) + of->rows[i].sum.unasked;
    fprintf(out, "\nBreaches of the contract: %" PRIu64 "\n", sum);
    for (int i = 0; i < of->row_count; i++)
        print_breaches_of(out, &of->rows[i]);
}

/* How the candidate is named on a command line. */
static void print_option(FILE *out, const judging_plan *plan)
{
    static const char *const forms[] = {
        [SUBJECT_TIER] = "--tier %s",
        [SUBJECT_LIBRARY] = "--candidate '%s'",
        [SUBJECT_COMMAND] = "--command '%s'",
    };
    fprintf(out, forms[plan->subject], plan->name);
    fputs(plan->how.inputs == INPUTS_FLOAT ? " --inputs float" : "", out);
    fputs(plan->by_reference ? " --truth reference\n" : "\n", out);
}

static void print_worst_case(FILE *out, const judging_plan *plan, const worst_case *one)
{
    const worst_lines lines = worst_lines_of(one);
    fprintf(out, "\n%s (%s %s)", worst_name(one->kind), sure_shape_name(one->shape),
            judging_row_name(one->which));
    if (one->kind >= FAULTS)
        fprintf(out, ", %.6g ulps", worst_size(one->kind, &one->found, one->in));
    fprintf(out, "\n  answer  %s\n  right   %s\n", lines.given, lines.right);
    if (plan->subject == SUBJECT_ANSWERS) { /* who can't be asked again */
        fprintf(out, "  case    %s\n", lines.question);
        return;
    }
    fprintf(out, "  echo '%s' | surehit judge --cases - ", lines.question);
    print_option(out, plan);
}

void judging_print_worst(FILE *out, const judging_plan *plan, const judging_findings *of)
{
    if (of->worst_count > 0)
        fputs("\nWorst cases, one of each kind, made simple\n", out);
    for (int i = 0; i < of->worst_count; i++)
        print_worst_case(out, plan, &of->worst[i]);
}

int judging_print_promises(FILE *out, const promises *all, const judging_findings *of)
{
    int broken = 0;
    if (all->count > 0)
        fputs("\nRequired\n", out);
    for (int n = 0; n < all->count; n++) {
        char line[CASE_LINE_MAX];
        bool kept = true;
        double is;
        promise_print(&all->list[n], line);
        for (int i = 0; i < of->row_count; i++) {
            const judging_row *row = &of->rows[i];
            if (promise_kept(&all->list[n], &row->sum, &is))
                continue;
            fprintf(out, "  BROKEN  %s: %s %s: %.6g\n", line, sure_shape_name(row->shape),
                    judging_row_name(row->which), is);
            kept = false;
        }
        if (kept)
            fprintf(out, "  kept    %s\n", line);
        broken += !kept;
    }
    return broken;
}
