/* Scenes by tiers: how many pixels show the wrong object, and what a pixel takes. */
#include "report_parts.h"

static uint64_t pixels_of(const report_trade *trade)
{
    return (uint64_t)trade->width * (uint64_t)trade->height;
}

static void print_introduction(FILE *out, const report_trade *trade)
{
    fprintf(out,
            "<section id=scenes><h2>What being right costs, scene by scene</h2>\n"
            "<p>%d %s by every tier. Left: pixels that show another object than they should, or "
            "one where there is none, or none where there is one. Right: processor time a pixel, "
            "with its lights and mirrors.</p>\n",
            trade->count, trade->count == 1 ? "scene" : "scenes");
}

static void print_head(FILE *out)
{
    fprintf(out,
            "<div class=box tabindex=0><table class=trade><thead><tr><th></th>"
            "<th class=group colspan=%d>pixels that show the wrong object</th>"
            "<th class=group colspan=%d>microseconds a pixel</th></tr>\n<tr><th>scene</th>",
            SURE_TIERS, SURE_TIERS);
    for (int i = 0; i < 2 * SURE_TIERS; i++)
        fprintf(out, "<th scope=col>%s</th>", sure_tier_name((sure_tier)(i % SURE_TIERS)));
    fputs("</tr></thead>\n", out);
}

/* Exact is what the others are held against. */
static void print_wrong(FILE *out, int tier, uint64_t wrong, double share)
{
    char text[REPORT_NUMBER];
    report_count(wrong, text);
    if (tier == SURE_TIER_EXACT)
        fputs("<td class=h0>=</td>", out);
    else
        fprintf(out, "<td class=%s>%s</td>", report_heat(share), text);
}

static void print_cells(FILE *out, const uint64_t wrong[SURE_TIERS],
                        const double nanoseconds[SURE_TIERS], uint64_t pixels)
{
    for (int tier = 0; tier < SURE_TIERS; tier++)
        print_wrong(out, tier, wrong[tier], (double)wrong[tier] / (double)pixels);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        double time = nanoseconds[tier] / 1000;
        fprintf(out, "<td>%.*f</td>", time < 9.995 ? 2 : 1, time);
    }
    fputs("</tr>\n", out);
}

static void print_row(FILE *out, const report_trade *trade, const report_trade_row *row)
{
    fputs("<tr><th scope=row title=\"", out);
    report_text(out, row->name);
    fputs("\">", out);
    report_text(out, row->name);
    fputs("</th>", out);
    print_cells(out, row->wrong, row->nanoseconds, pixels_of(trade));
}

/* All pictures are of one size, so that the mean over the scenes is that over all pixels. */
static void print_sums(FILE *out, const report_trade *trade)
{
    uint64_t wrong[SURE_TIERS] = {0}, scenes[SURE_TIERS] = {0};
    double nanoseconds[SURE_TIERS] = {0};
    for (int i = 0; i < trade->count * SURE_TIERS; i++) {
        const report_trade_row *row = &trade->rows[i / SURE_TIERS];
        wrong[i % SURE_TIERS] += row->wrong[i % SURE_TIERS];
        scenes[i % SURE_TIERS] += row->wrong[i % SURE_TIERS] > 0;
        nanoseconds[i % SURE_TIERS] += row->nanoseconds[i % SURE_TIERS] / trade->count;
    }
    fputs("<tr class=sum><th scope=row>all</th>", out);
    print_cells(out, wrong, nanoseconds, pixels_of(trade) * (uint64_t)trade->count);
    fprintf(out, "<tr class=sum><th scope=row>scenes, of %d</th>", trade->count);
    for (int tier = 0; tier < SURE_TIERS; tier++)
        print_wrong(out, tier, scenes[tier], 0);
    fprintf(out, "<td colspan=%d></td></tr>\n", SURE_TIERS);
}

static void print_how(FILE *out, const report_trade *trade)
{
    char each[REPORT_NUMBER], all[REPORT_NUMBER];
    report_count(pixels_of(trade), each);
    report_count(pixels_of(trade) * (uint64_t)trade->count, all);
    report_print_key(out);
    fprintf(out,
            " per cent of the pixels</p>\n<p class=soft>Each scene is drawn with %d × %d pixels, "
            "whatever its file says: %s a scene, %s in all. Wrong is a pixel whose own ray meets "
            "first something else than the exact tier says. = : exact is not held against itself; "
            "docs/accuracy.md holds all tiers against an independent reference, and counts wrong "
            "colours too. Time: one thread’s processor time for the whole picture, light followed "
            "from the eye alone, over its pixels; the median of %d rounds, the tiers in turn. In "
            "the row “all”: the sum of the pixels, and the mean time over all of them; below it: "
            "in how many scenes a pixel is wrong.</p></section>\n",
            trade->width, trade->height, each, all, trade->rounds);
}

void report_print_trade(FILE *out, const report_trade *trade)
{
    print_introduction(out, trade);
    print_head(out);
    fputs("<tbody>", out);
    for (int i = 0; i < trade->count; i++)
        print_row(out, trade, &trade->rows[i]);
    print_sums(out, trade);
    fputs("</tbody></table></div>\n", out);
    print_how(out, trade);
}
