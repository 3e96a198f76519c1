/* SPDX-License-Identifier: MIT */
/* The bars: how many times the naive peer's time a tier may take. `meson compile check-bars` runs
 * this program. The bars are for a build with -Dnative=true, where everything that is measured is
 * compiled for this very machine. Noise must not break a build, so a bar that does not hold is only
 * marked; --require-bars makes it the exit status. */
#include "../../src/judge/bench/bench.h"
#include "../../src/support/median.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Flat shapes have no number of their own for `certain`: they are held to the cylinder's. */
static const struct {
    sure_tier tier;
    regime which;
    double most, of[SURE_SHAPES]; /* a shape's own, where it has one */
} bars[] = {
    {SURE_TIER_TEXTBOOK, REGIME_TYPICAL, 1.05, {0}},
    {SURE_TIER_CERTAIN, REGIME_TYPICAL, 1.25, {[SURE_SHAPE_SPHERE] = 1.15}},
    {SURE_TIER_CERTAIN, REGIME_GRAZING, 6, {0}},
    {SURE_TIER_CERTAIN, REGIME_TANGENT, 30, {0}},
    {SURE_TIER_EXACT, REGIME_TYPICAL, 6, {0}},
    {SURE_TIER_EXACT, REGIME_GRAZING, 12, {0}},
    {SURE_TIER_EXACT, REGIME_TANGENT, 40, {0}},
};
#define BARS (int)(sizeof bars / sizeof *bars)

static const regime regimes[] = {REGIME_TYPICAL, REGIME_GRAZING, REGIME_TANGENT};
#define BAR_REGIMES (int)(sizeof regimes / sizeof *regimes)

/* Noise may outlast a row's patience: so all rows are measured in rounds, and a bar is held against
 * the middle one of its ratios. */
enum { ROUNDS = 3, ROWS = SURE_SHAPES * BAR_REGIMES };

/* row: of the first round, another round's is ROWS behind. The rows' own lines have quartiles. */
static bool print_bar(const bench_row *row, int bar)
{
    sure_tier tier = bars[bar].tier;
    double ratios[ROUNDS], own = bars[bar].of[row->shape], most = own > 0 ? own : bars[bar].most;
    for (int round = 0; round < ROUNDS; round++)
        ratios[round] = row[round * ROWS].results[BENCH_TIER(tier)].over_naive.median;
    double ratio = median_of(ratios, ROUNDS);
    printf("%-9s %-8s %-9s %7.2f  <= %5.2f  %s\n", sure_shape_name(row->shape),
           regime_name(row->which), sure_tier_name(tier), ratio, most,
           ratio <= most ? "holds" : "DOES NOT HOLD");
    return ratio <= most;
}

/* Returns how many bars do not hold. */
static int print_bars(const bench_row *rows)
{
    int broken = 0;
    printf("\n%-9s %-8s %-9s %7s  %s\n", "shape", "regime", "tier", "/naive", "bar");
    for (int bar = 0; bar < BARS; bar++) {
        for (int i = 0; i < ROWS; i++)
            broken += rows[i].which == bars[bar].which && !print_bar(&rows[i], bar);
    }
    printf("%d of %d bars do not hold\n", broken, BARS * SURE_SHAPES);
    return broken;
}

int main(int count, char **words)
{
    static bench_row rows[ROUNDS * ROWS];
    bool required = count == 2 && strcmp(words[1], "--require-bars") == 0;
    if (count > 1 && !required) {
        fprintf(stderr, "usage: %s [--require-bars]\n", words[0]);
        return 2;
    }
    const bench_plan plan = {
        .cases = BENCH_CASES, .repeats = BENCH_REPEATS, .seconds = BENCH_SECONDS};
    bench_print_head(&plan, SUREHIT_FLAGS);
    for (int i = 0; i < ROUNDS * ROWS; i++) {
        int row = i % ROWS;
        if (!bench_measure(&plan, (sure_shape)(row / BAR_REGIMES), regimes[row % BAR_REGIMES],
                           BENCH_MIXED, &rows[i])) {
            fprintf(stderr, "%s: no memory\n", words[0]);
            return 2;
        }
        bench_print_row(&plan, &rows[i]);
        fflush(stdout);
    }
    return print_bars(rows) > 0 && required ? EXIT_FAILURE : EXIT_SUCCESS;
}
