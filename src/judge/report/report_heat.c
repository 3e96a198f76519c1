/* Regimes by candidates: the share of wrong decisions, as a number and as a colour. */
#include "report_parts.h"

#include <inttypes.h>

static void print_head(FILE *out, const report_candidate *list, int count, int shape)
{
    fputs("<thead><tr><th>regime</th><th class=turned><span>cases</span></th>", out);
    for (int i = 0; i < count; i++) {
        if (!report_answers(&list[i], shape))
            continue;
        fputs("<th class=turned scope=col><span>", out);
        report_text(out, list[i].name);
        fputs("</span></th>", out);
    }
    fputs("</tr></thead>\n", out);
}

/* A cell's share is of the valid cases; a dagger says that there is more than wrong decisions. */
static void print_cell(FILE *out, const report_candidate *who, const report_row *row)
{
    char text[REPORT_NUMBER];
    double share = row->valid > 0 ? (double)row->wrong / (double)row->valid : 0;
    if (row->cases == 0 || report_is_measure(who)) {
        fprintf(out, "<td class=h0>%s</td>", row->cases == 0 ? "" : "=");
        return;
    }
    report_percent(share, text);
    fprintf(out, "<td class=%s>%s", report_heat(share), text);
    if (row->breaches + row->unasked > 0)
        fprintf(out,
                "<abbr title='%" PRIu32 " breaches of the contract, %" PRIu32
                " cases given up'>†</abbr>",
                row->breaches, row->unasked);
    fputs("</td>", out);
}

static void print_row(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                      int shape, int which)
{
    char cases[REPORT_NUMBER];
    report_count(report_cases(plan, (regime)which), cases);
    fprintf(out, "<tr><th scope=row>%s</th><td class=cases>%s</td>", regime_name((regime)which),
            cases);
    for (int i = 0; i < count; i++) {
        if (report_answers(&list[i], shape))
            print_cell(out, &list[i], &list[i].rows[shape][which]);
    }
    fputs("</tr>\n", out);
}

void report_print_key(FILE *out)
{
    fputs("<p class=key><span class=h0>0</span> <span class=h1>≤ 0.1</span> "
          "<span class=h2>≤ 1</span> <span class=h3>≤ 5</span> <span class=h4>≤ 20</span> "
          "<span class=h5>more</span>",
          out);
}

/* Of those who are not held against exact. */
static void print_marks(FILE *out, const report_candidate *list, int count)
{
    bool reference = false, like = false;
    for (int i = 0; i < count; i++) {
        reference |= list[i].truth == REPORT_BY_REFERENCE;
        like |= list[i].truth == REPORT_BY_LIKE;
    }
    if (reference)
        fprintf(out, "; certain and exact, held against CGAL: %d times as many cases",
                REPORT_REFERENCE_CASES);
    if (like)
        fputs("; * held against exact, = itself: no independent evidence", out);
}

void report_print_heat(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                       int shape)
{
    fputs("<div class=box tabindex=0><table class=heat>", out);
    print_head(out, list, count, shape);
    fputs("<tbody>", out);
    for (int which = 0; which < REGIMES; which++) {
        if (plan->wanted[shape][which])
            print_row(out, plan, list, count, shape, which);
    }
    fputs("</tbody></table></div>\n", out);
    report_print_key(out);
    fputs(" per cent of the valid cases; empty: floats can’t say such numbers", out);
    print_marks(out, list, count);
    fputs("</p>\n", out);
}
