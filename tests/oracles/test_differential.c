/* Every tier against the reference, in every regime of one shape. Arguments: the shape; then, if
 * not the default, cases a regime and the seed. The printed table is the result for tiers that
 * promise nothing; certain and exact fail on the first wrong decision, exact on the first wrong t.
 * Of these two the campaign (campaign.c) asks more, more often. */
#include "campaign_tally.h"
#include "reference.h"

#include <stdio.h>
#include <stdlib.h>

enum { LEAST_A_REGIME = 5000, LEAST_A_SHAPE = 100000 };

static void print_head(void)
{
    printf("%-9s %-14s %-9s %8s %7s %7s %7s %7s | %% of right hits, t off by ulps\n", "shape",
           "regime", "tier", "cases", "wrong%", "hit+", "hit-", "part");
    printf("%-66s | %6s %6s %6s %6s %6s %6s\n", "", "0", "1", "<=4", "<=64", "<=2^16", "more");
}

static void print_row(const char *shape, const char *name, sure_tier tier, const pair_tally *pair)
{
    const tier_tally *sum = &pair->tiers[tier];
    uint64_t right_hits = tally_right_hits(sum);
    printf("%-9s %-14s %-9s %8llu %7.3f %7llu %7llu %7llu |", shape, name, sure_tier_name(tier),
           (unsigned long long)pair->cases, 100.0 * (double)tally_wrong(sum) / (double)pair->cases,
           (unsigned long long)sum->false_hits, (unsigned long long)sum->false_misses,
           (unsigned long long)sum->wrong_parts);
    for (int b = 0; b < TALLY_BINS; b++)
        printf(" %6.2f", right_hits == 0 ? 0 : 100.0 * (double)sum->ulps[b] / (double)right_hits);
    printf("\n");
}

/* The first case of a regime that breaks a tier's promise. */
static void print_broken(const sure_case *question, sure_tier tier, const tally_truth *truth,
                         sure_status status, const sure_hit *hit)
{
    char line[CASE_LINE_MAX];
    case_print(question, line);
    printf("%s\n  %s %s", line, sure_tier_name(tier), sure_status_name(status));
    if (status == SURE_HIT)
        printf(" %a %s", hit->t, sure_part_name(hit->part));
    printf(", true %s", sure_status_name(truth->status));
    if (truth->status == SURE_HIT)
        printf(" %a %s", truth->t, sure_part_name(truth->part));
    printf("\n");
}

/* All tiers know invalid input. */
static bool keeps_promise(const tier_tally *sum, sure_tier tier, bool right)
{
    if (tier < SURE_TIER_CERTAIN)
        return sum->wrong_validity == 0;
    return right && (tier < SURE_TIER_EXACT || sum->ulps[0] == tally_right_hits(sum));
}

/* False on the first broken promise. */
static bool ask(const sure_case *question, pair_tally *sum)
{
    tally_truth truth;
    truth.status = reference_hit(&question->ray, &question->object, &truth.t, &truth.part, NULL);
    tally_truth_seen(sum, truth.status);
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        sure_hit hit;
        sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
        bool right = tally_hit(&sum->tiers[tier], tier, &truth, status, &hit);
        if (!keeps_promise(&sum->tiers[tier], tier, right)) {
            print_broken(question, tier, &truth, status, &hit);
            return false;
        }
    }
    return true;
}

/* One regime for all tiers; false if a promise is broken. */
static bool run(sure_shape shape, regime which, uint64_t cases, uint64_t seed, pair_tally *total)
{
    pair_tally sum = {0};
    bool kept = true;
    for (uint64_t i = 0; kept && i < cases; i++) {
        sure_case question = regime_case(shape, which, seed, i);
        kept = ask(&question, &sum);
    }
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
        print_row(sure_shape_name(shape), regime_name(which), tier, &sum);
    tally_add(total, &sum);
    if (kept && (sum.hits == 0 || sum.misses == 0)) {
        printf("%s %s: the reference saw %llu hits and %llu misses\n", sure_shape_name(shape),
               regime_name(which), (unsigned long long)sum.hits, (unsigned long long)sum.misses);
        return false;
    }
    return kept;
}

int main(int argc, char **argv)
{
    sure_shape shape;
    if (argc < 2 || argc > 4 || !sure_shape_from_name(argv[1], &shape)) {
        fprintf(stderr, "usage: test_differential SHAPE [CASES [SEED]]\n");
        return 2;
    }
    uint64_t regimes = 0, broken = 0, seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
    pair_tally total = {0};
    for (regime r = 0; r < REGIMES; r++)
        regimes += (uint64_t)regime_applies(shape, r);
    uint64_t cases = (LEAST_A_SHAPE + regimes - 1) / regimes;
    cases = cases > LEAST_A_REGIME ? cases : LEAST_A_REGIME;
    if (argc > 2)
        cases = strtoull(argv[2], NULL, 10);
    print_head();
    for (regime r = 0; r < REGIMES; r++) {
        if (regime_applies(shape, r))
            broken += !run(shape, r, cases, seed, &total);
    }
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
        print_row(sure_shape_name(shape), "all", tier, &total);
    printf("%d passed, %d failed\n", broken == 0, broken != 0);
    return broken == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
