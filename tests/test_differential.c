/* Every tier against the reference, in every regime of one shape. Arguments: the shape; then, if
 * not the default, cases a regime and the seed. The printed table is the result for tiers that
 * promise nothing; a tier that promises right decisions fails on the first wrong one. */
#include "case.h"
#include "reference.h"
#include "regimes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_A_REGIME = 5000, LEAST_A_SHAPE = 100000 };

/* Distance of t from the correctly rounded one, in ulps of the tier's precision, by upper ends. */
static const uint64_t bins[] = {0, 1, 4, 64, 65536, UINT64_MAX};
enum { BINS = sizeof bins / sizeof *bins };

typedef struct {
    uint64_t false_hits, false_misses, wrong_parts, wrong_validity;
    uint64_t right_hits, ulps[BINS];
} tally;

static int precision_shift(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 29 : 0;
}

static void count(tally *sum, const sure_case *question, sure_tier tier, sure_status status,
                  double t, sure_part part)
{
    sure_hit hit;
    sure_status given = sure_object_hit(&question->ray, &question->object, tier, &hit);
    if ((given == SURE_INVALID) != (status == SURE_INVALID))
        sum->wrong_validity++;
    else if (given != status)
        given == SURE_HIT ? sum->false_hits++ : sum->false_misses++;
    else if (status == SURE_HIT && hit.part != part)
        sum->wrong_parts++;
    else if (status == SURE_HIT) {
        uint64_t away = reference_ulps(hit.t, t) >> precision_shift(tier);
        int bin = 0;
        while (away > bins[bin])
            bin++;
        sum->right_hits++;
        sum->ulps[bin]++;
    }
}

static uint64_t wrong(const tally *sum)
{
    return sum->false_hits + sum->false_misses + sum->wrong_parts + sum->wrong_validity;
}

static void add(tally *total, const tally *sum)
{
    total->false_hits += sum->false_hits;
    total->false_misses += sum->false_misses;
    total->wrong_parts += sum->wrong_parts;
    total->wrong_validity += sum->wrong_validity;
    total->right_hits += sum->right_hits;
    for (int b = 0; b < BINS; b++)
        total->ulps[b] += sum->ulps[b];
}

static void print_head(void)
{
    printf("%-9s %-14s %-9s %8s %7s %7s %7s %7s | %% of right hits, t off by ulps\n", "shape",
           "regime", "tier", "cases", "wrong%", "hit+", "hit-", "part");
    printf("%-66s | %6s %6s %6s %6s %6s %6s\n", "", "0", "1", "<=4", "<=64", "<=2^16", "more");
}

static void print_row(const char *shape, const char *name, sure_tier tier, uint64_t cases,
                      const tally *sum)
{
    printf("%-9s %-14s %-9s %8llu %7.3f %7llu %7llu %7llu |", shape, name, sure_tier_name(tier),
           (unsigned long long)cases, 100.0 * (double)wrong(sum) / (double)cases,
           (unsigned long long)sum->false_hits, (unsigned long long)sum->false_misses,
           (unsigned long long)sum->wrong_parts);
    for (int b = 0; b < BINS; b++)
        printf(" %6.2f", sum->right_hits == 0
                             ? 0
                             : 100.0 * (double)sum->ulps[b] / (double)sum->right_hits);
    printf("\n");
}

/* One regime for all tiers; the number of broken promises. */
static int run(sure_shape shape, regime which, uint64_t cases, uint64_t seed, tally totals[])
{
    tally sums[SURE_TIERS] = {{0}};
    uint64_t hits = 0, misses = 0;
    for (uint64_t i = 0; i < cases; i++) {
        sure_case question = regime_case(shape, which, seed, i);
        double t = 0;
        sure_part part = SURE_PART_SURFACE;
        sure_status status = reference_hit(&question.ray, &question.object, &t, &part, NULL);
        hits += status == SURE_HIT;
        misses += status == SURE_MISS;
        for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
            count(&sums[tier], &question, tier, status, t, part);
    }
    int broken = 0;
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        print_row(sure_shape_name(shape), regime_name(which), tier, cases, &sums[tier]);
        add(&totals[tier], &sums[tier]);
        broken += sums[tier].wrong_validity > 0; /* all tiers know invalid input */
    }
    if (hits == 0 || misses == 0) {
        printf("%s %s: the reference saw %llu hits and %llu misses\n", sure_shape_name(shape),
               regime_name(which), (unsigned long long)hits, (unsigned long long)misses);
        broken++;
    }
    return broken;
}

int main(int argc, char **argv)
{
    sure_shape shape;
    if (argc < 2 || argc > 4 || !sure_shape_from_name(argv[1], &shape)) {
        fprintf(stderr, "usage: test_differential SHAPE [CASES [SEED]]\n");
        return 2;
    }
    uint64_t regimes = 0, broken = 0, seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
    tally totals[SURE_TIERS] = {{0}};
    for (regime r = 0; r < REGIMES; r++)
        regimes += (uint64_t)regime_applies(shape, r);
    uint64_t cases = (LEAST_A_SHAPE + regimes - 1) / regimes;
    cases = cases > LEAST_A_REGIME ? cases : LEAST_A_REGIME;
    if (argc > 2)
        cases = strtoull(argv[2], NULL, 10);
    print_head();
    for (regime r = 0; r < REGIMES; r++) {
        if (regime_applies(shape, r))
            broken += (uint64_t)run(shape, r, cases, seed, totals);
    }
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
        print_row(sure_shape_name(shape), "all", tier, cases * regimes, &totals[tier]);
    printf("%d passed, %d failed\n", broken == 0, broken != 0);
    return broken == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
