/* How far off the rightly found t are: for each candidate the shares of hits by powers of two of
 * the error, typical rays above a line and all other regimes below it. */
#include "report_parts.h"

#include <math.h>
#include <string.h>

#define WIDTH 360
#define LETTER 6.1 /* the width of one, upwards */
#define RIGHT 356
#define ROW 34
#define MIDDLE 17
#define HIGHEST 15 /* of a bar that holds all hits */
#define AXIS 30

/* Where the bars begin, behind the names. */
typedef struct {
    double left;
} field;

/* A small share must be seen beside a large one: heights grow with its root. */
static double height_of(uint64_t hits, uint64_t all)
{
    return all > 0 ? HIGHEST * sqrt((double)hits / (double)all) : 0;
}

static double place_of(field in, int class)
{
    return in.left + (RIGHT - in.left) * (double)class / SIZE_CLASSES;
}

static void print_bars(FILE *out, field in, const report_sum *sum, int middle, bool upwards)
{
    fprintf(out, "<path class=%s d='", upwards ? "typical" : "hard");
    for (int i = 0; i < SIZE_CLASSES; i++) {
        double height = height_of(sum->t_classes[i], sum->t_count);
        if (height > 0)
            fprintf(out, "M%.1f %dv%.2fh%.2fv%.2fz", place_of(in, i), middle,
                    upwards ? -height : height, place_of(in, 1) - place_of(in, 0) - 0.5,
                    upwards ? height : -height);
    }
    fputs("'/>", out);
}

static void print_row(FILE *out, field in, const report_candidate *who, int shape, int top)
{
    report_sum typical = report_sum_of(who, shape, REPORT_TYPICAL);
    report_sum hard = report_sum_of(who, shape, REPORT_HARD);
    fprintf(out, "<text class=name x=%.1f y=%.1f text-anchor=end>", in.left - 6,
            top + MIDDLE + 3.6);
    report_text(out, who->name);
    fprintf(out, "</text><path class=grid d='M%.1f %dH%d'/>", in.left, top + MIDDLE, RIGHT);
    print_bars(out, in, &typical, top + MIDDLE, true);
    print_bars(out, in, &hard, top + MIDDLE, false);
    fputc('\n', out);
}

/* Class 0 is no error, class 1 + n ends at 2^n. */
static void print_axis(FILE *out, field in, int bottom)
{
    static const struct {
        int class;
        const char *text;
    } ticks[] = {{0, "0"},    {9, "2⁸"},   {17, "2¹⁶"}, {25, "2²⁴"}, {33, "2³²"},
                 {41, "2⁴⁰"}, {49, "2⁴⁸"}, {57, "2⁵⁶"}, {64, "2⁶³"}};
    for (size_t i = 0; i < sizeof ticks / sizeof *ticks; i++) {
        double x = place_of(in, ticks[i].class) + (place_of(in, 1) - place_of(in, 0)) / 2;
        fprintf(out, "<path class=grid d='M%.1f 0V%d'/>", x, bottom);
        fprintf(out, "<text x=%.1f y=%d text-anchor=middle>%s</text>\n", x, bottom + 12,
                ticks[i].text);
    }
    fprintf(out, "<text class=axis x=%.1f y=%d text-anchor=middle>error of t, in ulps</text>\n",
            (in.left + RIGHT) / 2, bottom + 27);
}

void report_print_histograms(FILE *out, const report_candidate *list, int count, int shape)
{
    int rows = 0;
    field in = {60};
    for (int i = 0; i < count; i++) {
        if (!report_answers(&list[i], shape))
            continue;
        rows++;
        in.left = fmax(in.left, LETTER * (double)strlen(list[i].name) + 8);
    }
    in.left = fmin(in.left, RIGHT / 2.0);
    fprintf(out,
            "<svg class=histogram viewBox='0 0 %d %d' role=img aria-label='Errors of t: %s'>\n",
            WIDTH, rows * ROW + AXIS, sure_shape_name((sure_shape)shape));
    print_axis(out, in, rows * ROW);
    rows = 0;
    for (int i = 0; i < count; i++) {
        if (report_answers(&list[i], shape))
            print_row(out, in, &list[i], shape, rows++ * ROW);
    }
    fputs("</svg>\n", out);
}
