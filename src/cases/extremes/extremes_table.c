#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "extremes_table.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "extremes.h"

/* What a tier made of some cases. */
typedef struct {
    uint64_t cases, wrong;
    uint64_t known, exact; /* right hits whose t* is known; those where t is t* */
    double nanoseconds;    /* all cases together */
} tally;

static void tally_add(tally *sum, const tally *more)
{
    sum->cases += more->cases;
    sum->wrong += more->wrong;
    sum->known += more->known;
    sum->exact += more->exact;
    sum->nanoseconds += more->nanoseconds;
}

/* Cases are made, asked and judged in batches, so that no count asks for memory. */
#define BATCH 1024
#define LEAST_REPEATS 3
#define MOST_REPEATS 15
#define ENOUGH_NANOSECONDS 2e6 /* a slow tier is not repeated for longer */

typedef struct {
    int size;
    extreme cases[BATCH];
    sure_status status[BATCH];
    sure_hit hit[BATCH];
} batch;

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return (double)at.tv_sec * 1e9 + (double)at.tv_nsec;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double ask_once(batch *asked, sure_tier tier)
{
    double start = now();
    for (int i = 0; i < asked->size; i++) {
        const sure_case *question = &asked->cases[i].question;
        asked->status[i] =
            sure_object_hit(&question->ray, &question->object, tier, &asked->hit[i]);
    }
    return now() - start;
}

/* The median of some repeats: an interrupted one does not count. */
static double ask(batch *asked, sure_tier tier)
{
    double took[MOST_REPEATS], fastest = INFINITY;
    int repeats = 0;
    while (repeats < LEAST_REPEATS ||
           (repeats < MOST_REPEATS && repeats * fastest < ENOUGH_NANOSECONDS)) {
        took[repeats] = ask_once(asked, tier);
        fastest = fmin(fastest, took[repeats]);
        repeats++;
    }
    qsort(took, (size_t)repeats, sizeof took[0], by_value);
    return took[repeats / 2];
}

static void judge(const batch *answered, tally *sum)
{
    for (int i = 0; i < answered->size; i++) {
        const extreme *truth = &answered->cases[i];
        bool right = answered->status[i] == truth->status &&
                     (truth->status != SURE_HIT || answered->hit[i].part == truth->part);
        sum->cases++;
        sum->wrong += !right;
        if (right && truth->status == SURE_HIT && truth->t_known) {
            sum->known++;
            sum->exact += answered->hit[i].t == truth->t;
        }
    }
}

static void try_family(sure_shape shape, int family, uint64_t count, tally sums[SURE_TIERS])
{
    batch asked;
    for (uint64_t done = 0; done < count; done += (uint64_t)asked.size) {
        asked.size = count - done < BATCH ? (int)(count - done) : BATCH;
        for (int i = 0; i < asked.size; i++)
            asked.cases[i] = extreme_case(shape, family, done + (uint64_t)i);
        for (int tier = 0; tier < SURE_TIERS; tier++) {
            sums[tier].nanoseconds += ask(&asked, (sure_tier)tier);
            judge(&asked, &sums[tier]);
        }
    }
}

/* In per cent; 0 and 100 are printed for none and all alone. */
static void print_share(FILE *out, int width, int decimals, uint64_t some, uint64_t all)
{
    double percent = 100 * (double)some / (double)all;
    double smallest = decimals == 0 ? 1 : 0.1;
    char text[16];
    if (all == 0)
        snprintf(text, sizeof text, "-");
    else if (some == 0 || some == all)
        snprintf(text, sizeof text, "%.0f", percent);
    else if (percent < smallest)
        snprintf(text, sizeof text, "<%.*f", decimals, smallest);
    else if (percent > 100 - smallest)
        snprintf(text, sizeof text, ">%.*f", decimals, 100 - smallest);
    else
        snprintf(text, sizeof text, "%.*f", decimals, percent);
    fprintf(out, "%*s", width, text);
}

static void print_time(FILE *out, int width, double nanoseconds, uint64_t cases)
{
    double each = nanoseconds / (double)cases;
    if (cases == 0)
        fprintf(out, "%*s", width, "-");
    else if (each < 9999.5)
        fprintf(out, "%*.0f", width, each);
    else
        fprintf(out, "%*.0fk", width - 1, each / 1000);
}

/* Labels and each tier take this many columns: five tiers fit in 100. */
#define LABEL 20
#define WRONG 6
#define EXACT 5
#define TIME 5

static void print_head(FILE *out, uint64_t count)
{
    fprintf(out,
            "Extreme cases whose right answers are known from their making, %llu a row.\n"
            "  wrong  answers with the wrong status or part, %% of cases\n"
            "  t=     t exactly t*, %% of the right hits whose t* is a known double\n"
            "  ns     nanoseconds an answer (k: thousands)\n\n%*s",
            (unsigned long long)count, LABEL, "");
    for (int tier = 0; tier < SURE_TIERS; tier++)
        fprintf(out, "%*s", WRONG + EXACT + TIME, sure_tier_name((sure_tier)tier));
    fprintf(out, "\n%*s", LABEL, "");
    for (int tier = 0; tier < SURE_TIERS; tier++)
        fprintf(out, "%*s%*s%*s", WRONG, "wrong", EXACT, "t=", TIME, "ns");
    fputc('\n', out);
}

static void print_row(FILE *out, const char *indent, const char *label, const tally sums[])
{
    fprintf(out, "%s%-*s", indent, indent[0] ? LABEL - 2 : LABEL, label);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        print_share(out, WRONG, 1, sums[tier].wrong, sums[tier].cases);
        print_share(out, EXACT, 0, sums[tier].exact, sums[tier].known);
        print_time(out, TIME, sums[tier].nanoseconds, sums[tier].cases);
    }
    fputc('\n', out);
}

int extremes_table(FILE *out, uint64_t count)
{
    tally overall[SURE_TIERS] = {{0}};
    print_head(out, count);
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        tally of_shape[SURE_TIERS] = {{0}};
        fprintf(out, "%s\n", sure_shape_name((sure_shape)shape));
        for (int family = 0; family < extreme_families((sure_shape)shape); family++) {
            tally of_family[SURE_TIERS] = {{0}};
            try_family((sure_shape)shape, family, count, of_family);
            print_row(out, "  ", extreme_family_name((sure_shape)shape, family), of_family);
            for (int tier = 0; tier < SURE_TIERS; tier++)
                tally_add(&of_shape[tier], &of_family[tier]);
        }
        print_row(out, "  ", "all", of_shape);
        for (int tier = 0; tier < SURE_TIERS; tier++)
            tally_add(&overall[tier], &of_shape[tier]);
    }
    print_row(out, "", "all shapes", overall);
    return fflush(out) != 0 || ferror(out);
}
