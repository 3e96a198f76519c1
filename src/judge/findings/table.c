/* SPDX-License-Identifier: MIT */
#include "findings.h"

#include "../referee/referee_report.h"

#include "../../support/printable.h"
#include "../../support/shell.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

static void print_who(const identity *who)
{
    const char *words[] = {who->name, who->version, who->build};
    const char *before = "Candidate: ";
    for (int i = 0; i < 3; i++) {
        if (*words[i] == '\0')
            continue;
        fputs(before, stdout);
        printable_print(stdout, words[i]);
        before = i == 0 ? " " : ", ";
    }
    fputs(*before == 'C' ? "" : "\n", stdout);
}

void findings_print_head(const judging_plan *plan, const findings *of)
{
    bool is_tier = plan->subject == SUBJECT_TIER;
    printable_print(stdout, plan->name);
    printf(", held against %s", plan->by_reference ? "reference" : "exact");
    if (is_tier && plan->tier >= SURE_TIER_CERTAIN && !plan->by_reference)
        fputs(" (no independent evidence; --truth reference is)", stdout);
    if (plan->rows.set)
        printf(": set %s", plan->rows.set->name);
    if (!plan->cases)
        printf("%s %" PRIu64 " cases a row, seed %" PRIu64, plan->rows.set ? "," : ":", plan->count,
               plan->seed);
    putchar('\n');
    if (plan->subject == SUBJECT_TIER || plan->subject == SUBJECT_LIBRARY)
        print_who(&of->who);
    printf("Wrong: decisions, in %% of the valid cases, with a 95 %% interval. t: of hits rightly\n"
           "found, in ulps: not exceeded by so many; correctly rounded. ns: a ray%s,\n"
           "beside textbook and certain on the same cases%s.\n%s\n",
           plan->subject == SUBJECT_COMMAND ? ", lines read and written included" : "",
           is_tier ? ", all without normals" : ", with normals if it gives them",
           plan->instructions ? "instr: instructions a ray of the first cases, likewise.\n" : "");
    printf("%-*s %-13s %7s %-17s %7s %7s %7s | %8s %8s %8s %8s %6s | %8s %6s | %6s %5s %5s%s\n",
           of->width, "shape", "regime", "wrong %", " from .. to", "f. hit", "f. miss", "part",
           "t: 50 %", "99 %", "99.99 %", "most", "right%", "n: most", "right%", "ns", "textb",
           "cert", plan->instructions ? " |  instr textb  cert" : "");
}

/* "-" where no case was asked. */
static void print_share(const verdict *sum)
{
    if (sum->valid == 0) {
        printf(" %7s %-17s", "-", "");
        return;
    }
    char interval[32];
    double share = 100 * (double)sum->wrong / (double)sum->valid;
    snprintf(interval, sizeof interval, "%.3g .. %.3g", 100 * sum->wrong_share.lower,
             100 * sum->wrong_share.upper);
    int digits = sum->wrong == 0 ? 0 : share < 1 ? 4 : 2;
    printf(" %7.*f %-17s", digits, share, interval);
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
    if (of->building > 0)
        printf(", built in %.0f", of->building);
}

/* The first columns of a table. */
static void print_place(const judging_row *row, int width)
{
    judging_words words;
    printf("%-*s %-13s", width, judging_topic(row->asks, row->shape, words),
           judging_row_name(row->which));
}

void findings_print_row(const judging_row *row, int width)
{
    const verdict *sum = &row->sum;
    print_place(row, width);
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

/* Cases that are given have no picture. */
void findings_print_lengths(const findings *of)
{
    const char *head =
        "\nErrors of t as lengths, in pictures (camera): over the scene's size; in pixels,\n"
        "over what one of them covers at the hit.\n\n"
        "shape   size 50 %     99 %  99.99 %     most pix 50 %     99 %  99.99 %     most\n";
    for (int i = 0; i < of->row_count; i++) {
        const judging_row *row = &of->rows[i];
        bool has_picture = row->which == REGIME_CAMERA || row->which == JUDGING_GIVEN;
        if (row->asks != QUERY_HIT || !has_picture)
            continue;
        printf("%s%-8s", head, sure_shape_name(row->shape));
        print_sizes(&row->sum.t_extents, "-");
        print_sizes(&row->sum.t_pixels, "-");
        putchar('\n');
        head = "";
    }
}

void findings_print_margins(const judging_plan *plan, const candidate *asked, const findings *of)
{
    bool any = false;
    for (int i = 0; i < of->row_count; i++) {
        const judging_row *row = &of->rows[i];
        if (!referee_tells(&row->sum, &row->looked_at, &asked->entry))
            continue;
        if (!any)
            referee_print_head(of->width, &plan->told, &asked->entry);
        any = true;
        print_place(row, of->width);
        referee_print(&row->sum, &row->looked_at, &plan->told, &asked->entry);
    }
    if (of->left_out > 0)
        printf("\nCase lines of other shapes or regimes, left out: %" PRIu64 "\n", of->left_out);
}

static void print_breaches_of(const judging_row *row)
{
    const verdict *sum = &row->sum;
    const char *before = ": ";
    if (verdict_breaches(sum) + sum->faults[FAULT_REFUSED] + sum->unasked == 0)
        return;
    judging_words words;
    printf("  %s %s", judging_topic(row->asks, row->shape, words), judging_row_name(row->which));
    for (int i = FAULT_REFUSED; i < FAULTS; i++) {
        if (sum->faults[i] == 0)
            continue;
        printf("%s%s %" PRIu64, before, fault_name(i), sum->faults[i]);
        before = ", ";
    }
    if (sum->unasked > 0)
        printf("%sgiven up, not asked %" PRIu64, before, sum->unasked);
    putchar('\n');
}

void findings_print_breaches(const findings *of)
{
    uint64_t sum = 0;
    for (int i = 0; i < of->row_count; i++)
        sum += verdict_breaches(&of->rows[i].sum) + of->rows[i].sum.unasked;
    printf("\nBreaches of the contract: %" PRIu64 "\n", sum);
    for (int i = 0; i < of->row_count; i++)
        print_breaches_of(&of->rows[i]);
}

void findings_print_skipped(const findings *of)
{
    const char *head = "\nNot asked, since they are not in the entry or invalid as floats\n";
    for (int i = 0; i < of->row_count; i++) {
        const judging_row *row = &of->rows[i];
        judging_words words;
        if (row->sum.skipped == 0)
            continue;
        printf("%s  %s %s: %" PRIu64 "\n", head, judging_topic(row->asks, row->shape, words),
               judging_row_name(row->which), row->sum.skipped);
        head = "";
    }
}

/* How the candidate is named on a command line. */
static void print_option(const judging_plan *plan, query asks)
{
    static const char *const forms[] = {
        [SUBJECT_TIER] = " --tier ",
        [SUBJECT_LIBRARY] = " --candidate ",
        [SUBJECT_COMMAND] = " --command ",
    };
    static const char *const inputs[] = {" --inputs float", " --inputs double", ""};
    fputs(forms[plan->subject], stdout);
    shell_print(stdout, plan->name);
    fputs(plan->how.keep ? " --keep" : "", stdout);
    fputs(inputs[plan->how.inputs], stdout);
    if (asks != QUERY_HIT)
        printf(" --query %s", query_names[asks]);
    if (plan->how.entry) {
        fputs(" --entry ", stdout);
        shell_print(stdout, plan->how.entry);
    }
    if (plan->how.time_limit != CANDIDATE_TIME_LIMIT)
        printf(" --time-limit %g", plan->how.time_limit);
    if (plan->told.unit != MARGIN_SIZE)
        printf(" --margin %s", margin_unit_names[plan->told.unit]);
    fputs(plan->by_reference ? " --truth reference\n" : "\n", stdout);
}

static void print_conventions_of(sure_shape shape, const convention_words *said)
{
    printf("%-9s", sure_shape_name(shape));
    for (int i = 0; i < CONVENTIONS; i++) {
        const char *word = said->candidate[i], *right = said->contract[i];
        char both[2 * sizeof said->candidate[0] + 8];
        bool same = strcmp(word, right) == 0;
        snprintf(both, sizeof both, same ? "%s" : "%s (%s)", *word ? word : "-", right);
        printf(" %-13s", both);
    }
    putchar('\n');
}

void findings_print_conventions(const findings *of)
{
    fputs(
        "\nConventions, asked at an object of size 1 (in brackets the contract's where it differs)"
        "\n\nshape    ",
        stdout);
    for (int i = 0; i < CONVENTIONS; i++)
        printf(" %-13s", convention_name((convention)i));
    putchar('\n');
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (of->has_said[shape])
            print_conventions_of((sure_shape)shape, &of->said[shape]);
    }
}

static void print_worst_case(const judging_plan *plan, const worst_case *one)
{
    const example_lines lines = example_lines_of(&one->found);
    judging_words words;
    printf("\n%s (%s %s)", worst_name(one->kind), judging_topic(one->asks, one->shape, words),
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
    printf(one->which == JUDGING_GIVEN ? "  echo '%s' | " : "  echo '%s # %s' | ", lines.question,
           judging_row_name(one->which));
    shell_print_program(stdout);
    fputs(" judge --cases -", stdout);
    print_option(plan, one->asks);
}

void findings_print_worst(const judging_plan *plan, const findings *of)
{
    if (of->worst_count > 0)
        fputs("\nWorst cases, one of each kind, made simple\n", stdout);
    for (int i = 0; i < of->worst_count; i++)
        print_worst_case(plan, &of->worst[i]);
}

int findings_print_promises(const judging_plan *plan, findings *of)
{
    int broken = 0, rows = of->row_count;
    promised_row one;
    if (plan->required.count > 0)
        fputs("\nRequired\n", stdout);
    for (int n = 0; n < plan->required.count; n++) {
        bool none = true;
        of->kept[n] = true;
        for (int i = 0; i < rows && findings_promised(plan, of, n * rows + i, &one); i++) {
            none = none && one.none;
            if (one.kept)
                continue;
            judging_words words;
            printf("  BROKEN  %s: %s %s: %.6g%s\n", one.promised,
                   judging_topic(one.row->asks, one.row->shape, words),
                   judging_row_name(one.row->which), one.is, one.none ? ", none is told" : "");
            of->kept[n] = false;
        }
        if (of->kept[n] && none) {
            printf("  BROKEN  %s: there is none to compare\n", one.promised);
            of->kept[n] = false;
        }
        if (of->kept[n])
            printf("  kept    %s\n", one.promised);
        broken += !of->kept[n];
    }
    return broken;
}
