#include "judging_report.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

void judging_print_head(FILE *out, const judging_subject *subject)
{
    fprintf(out, "%s, held against %s", subject->candidate, subject->truth);
    if (subject->by_like)
        fputs(" (no independent evidence; --truth reference is)", out);
    if (subject->count > 0)
        fprintf(out, ": %" PRIu64 " cases a row, seed %" PRIu64, subject->count, subject->seed);
    fprintf(
        out,
        "\n"
        "Wrong: decisions, in %% of the valid cases, with a 95 %% interval. t: of hits rightly\n"
        "found, in ulps: not exceeded by so many; correctly rounded. ns: a ray%s,\n"
        "beside textbook and certain on the same cases%s.\n\n",
        subject->counts_text ? ", lines read and written included" : "",
        subject->is_tier ? ", all without normals" : ", with normals if it gives them");
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

static void print_t(FILE *out, const error_summary *of)
{
    if (of->count == 0) {
        fprintf(out, " | %8s %8s %8s %8s %6s", "", "", "", "", "");
        return;
    }
    fputs(" |", out);
    print_size(out, of->median);
    print_size(out, of->q99);
    print_size(out, of->q9999);
    print_size(out, of->most);
    print_right(out, of);
}

static void print_normal(FILE *out, const error_summary *of)
{
    if (of->count == 0) {
        fprintf(out, " | %8s %6s", "", "");
        return;
    }
    fputs(" |", out);
    print_size(out, of->most);
    print_right(out, of);
}

void judging_print_row(FILE *out, const judging_row *row)
{
    const verdict *sum = &row->sum;
    fprintf(out, "%-9s %-13s", sure_shape_name(row->shape), judging_row_name(row));
    print_share(out, sum);
    fprintf(out, " %7" PRIu64 " %7" PRIu64 " %7" PRIu64, sum->faults[FAULT_FALSE_HIT],
            sum->faults[FAULT_FALSE_MISS], sum->faults[FAULT_WRONG_PART]);
    print_t(out, &sum->t_ulps);
    print_normal(out, &sum->normal_ulps);
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
    fprintf(out, "  %s %s", sure_shape_name(row->shape), judging_row_name(row));
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

void judging_print_breaches(FILE *out, const judging_row *rows, int count)
{
    uint64_t sum = 0;
    for (int i = 0; i < count; i++)
        sum += verdict_breaches(&rows[i].sum) + rows[i].sum.unasked;
    fprintf(out, "\nBreaches of the contract: %" PRIu64 "\n", sum);
    for (int i = 0; i < count; i++)
        print_breaches_of(out, &rows[i]);
}

static void print_worst_case(FILE *out, const judging_subject *subject, const worst_case *one,
                             const char *met_in)
{
    char question[CASE_LINE_MAX], given[CASE_LINE_MAX], right[CASE_LINE_MAX];
    case_print(&one->found.question, question);
    reply_print(&one->found.given, given);
    case_answer_print(&one->found.truth, right);
    fprintf(out, "\n%s (%s %s)", worst_name(one->kind), sure_shape_name(one->shape), met_in);
    if (one->kind >= FAULTS)
        fprintf(out, ", %.6g ulps", worst_size(one->kind, &one->found, one->in));
    fprintf(out, "\n  answer  %s\n  right   %s\n", given, right);
    if (subject->option)
        fprintf(out, "  echo '%s' | surehit judge --cases - %s\n", question, subject->option);
    else
        fprintf(out, "  case    %s\n", question);
}

void judging_print_worst(FILE *out, const judging_subject *subject, const worst_case *list,
                         int count)
{
    if (count > 0)
        fputs("\nWorst cases, one of each kind, made simple\n", out);
    for (int i = 0; i < count; i++) {
        judging_row met = {.which = list[i].which};
        print_worst_case(out, subject, &list[i], judging_row_name(&met));
    }
}

int judging_print_promises(FILE *out, const promises *all, const judging_row *rows, int count)
{
    int broken = 0;
    if (all->count > 0)
        fputs("\nRequired\n", out);
    for (int n = 0; n < all->count; n++) {
        char line[CASE_LINE_MAX];
        int here = 0;
        double is;
        promise_print(&all->list[n], line);
        for (int i = 0; i < count; i++) {
            if (promise_kept(&all->list[n], &rows[i].sum, &is))
                continue;
            fprintf(out, "  BROKEN  %s: %s %s: %.6g\n", line, sure_shape_name(rows[i].shape),
                    judging_row_name(&rows[i]), is);
            here++;
        }
        if (here == 0)
            fprintf(out, "  kept    %s\n", line);
        broken += here > 0;
    }
    return broken;
}
