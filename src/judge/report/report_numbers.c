/* Sums over regimes, and numbers as people write them. */
#include "report_parts.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

bool report_is_measure(const report_candidate *who)
{
    return who->truth == REPORT_BY_LIKE && who->tier == SURE_TIER_EXACT;
}

bool report_answers(const report_candidate *who, int shape)
{
    for (int which = 0; which < REGIMES; which++) {
        if (who->rows[shape][which].cases > 0)
            return true;
    }
    return false;
}

static bool belongs(int which, report_part part)
{
    return (which == REGIME_TYPICAL) == (part == REPORT_TYPICAL);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void add(report_sum *sum, const report_row *row)
{
    sum->regimes++;
    sum->valid += row->valid;
    sum->wrong += row->wrong;
    sum->breaches += row->breaches;
    sum->unasked += row->unasked;
    sum->share += row->valid > 0 ? (double)row->wrong / (double)row->valid : 0;
    sum->t_count += row->t_count;
    sum->t_right += row->t_right;
    for (int i = 0; i < SIZE_CLASSES; i++)
        sum->t_classes[i] += row->t_classes[i];
    if (row->nanoseconds > sum->slowest)
        sum->slowest = row->nanoseconds;
}

report_sum report_sum_of(const report_candidate *who, int shape, report_part part)
{
    report_sum sum = {0};
    double times[REGIMES];
    int timed = 0;
    for (int which = 0; which < REGIMES; which++) {
        const report_row *row = &who->rows[shape][which];
        if (row->cases == 0 || !belongs(which, part))
            continue;
        add(&sum, row);
        if (row->nanoseconds > 0)
            times[timed++] = row->nanoseconds;
    }
    qsort(times, (size_t)timed, sizeof *times, by_size);
    if (timed > 0)
        sum.nanoseconds = (times[(timed - 1) / 2] + times[timed / 2]) / 2;
    if (sum.regimes > 0)
        sum.share /= sum.regimes;
    sum.upper = confidence_of(sum.wrong, sum.valid).upper;
    return sum;
}

void report_text(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        default: fputc((unsigned char)*text < ' ' ? ' ' : *text, out);
        }
    }
}

/* 4.2, 57, 340 */
static void two_digits(double number, const char *unit, char text[REPORT_NUMBER])
{
    int places = number < 10 ? 1 : 0;
    snprintf(text, REPORT_NUMBER, "%.*f%s", places, number, unit);
}

void report_time(double nanoseconds, char text[REPORT_NUMBER])
{
    if (nanoseconds <= 0)
        snprintf(text, REPORT_NUMBER, "–");
    else if (nanoseconds < 999.5)
        two_digits(nanoseconds, " ns", text);
    else if (nanoseconds < 999.5e3)
        two_digits(nanoseconds / 1e3, " µs", text);
    else
        two_digits(nanoseconds / 1e6, " ms", text);
}

void report_count(uint64_t number, char text[REPORT_NUMBER])
{
    char digits[REPORT_NUMBER];
    int length = snprintf(digits, sizeof digits, "%" PRIu64, number), at = 0;
    for (int i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            text[at++] = ',';
        text[at++] = digits[i];
    }
    text[at] = '\0';
}

void report_per_million(const report_sum *sum, char text[REPORT_NUMBER])
{
    if (sum->wrong == 0) {
        char cases[REPORT_NUMBER];
        report_count(sum->valid, cases);
        snprintf(text, REPORT_NUMBER, "none in %.20s", cases);
    } else if (sum->share * 1e6 < 9.95) {
        snprintf(text, REPORT_NUMBER, "%.1f", sum->share * 1e6);
    } else {
        report_count((uint64_t)llround(sum->share * 1e6), text);
    }
}

void report_ulps(double ulps, char text[REPORT_NUMBER])
{
    if (isinf(ulps))
        snprintf(text, REPORT_NUMBER, "∞");
    else if (ulps < 10000)
        snprintf(text, REPORT_NUMBER, "%.0f", ulps);
    else
        snprintf(text, REPORT_NUMBER, "10<sup>%.0f</sup>", floor(log10(ulps) + 0.5));
}

void report_percent(double share, char text[REPORT_NUMBER])
{
    double percent = 100 * share;
    int places = percent < 0.995 ? 2 : percent < 9.95 ? 1 : 0;
    if (share == 0)
        snprintf(text, REPORT_NUMBER, "0");
    else if (percent < 0.005)
        snprintf(text, REPORT_NUMBER, "&lt;0.01");
    else
        snprintf(text, REPORT_NUMBER, "%.*f", places, percent);
}

const char *report_heat(double share)
{
    return share == 0      ? "h0"
           : share <= 1e-3 ? "h1"
           : share <= 1e-2 ? "h2"
           : share <= 5e-2 ? "h3"
           : share <= 0.2  ? "h4"
                           : "h5";
}
