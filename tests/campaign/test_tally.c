/* SPDX-License-Identifier: MIT */
/* What a campaign counts of the hits that tiers answer. */
#include "suite.h"

#include "campaign_tally.h"

static const tally_truth right = {.status = SURE_HIT, .t = 1.5, .part = SURE_PART_WALL};

/* Where it is counted that t is so far off, as the only thing. */
static int bin_of(sure_tier tier, double off)
{
    const sure_hit hit = {.t = right.t + off, .part = right.part};
    tier_tally sum = {0}, expected = {0};
    int bin = 0;
    ck_assert(tally_hit(&sum, tier, &right, SURE_HIT, &hit));
    while (bin < TALLY_BINS - 1 && sum.ulps[bin] == 0)
        bin++;
    expected.ulps[bin] = 1;
    ck_assert_mem_eq(&sum, &expected, sizeof sum);
    return bin;
}

/* Of floats for float32, and of doubles for others. Parts of one are none. */
TEST(bins_are_of_the_tiers_ulps)
{
    static const int most[TALLY_BINS] = {0, 1, 4, 64, 65536, 100000};
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        const double ulp = tier == SURE_TIER_FLOAT32 ? 0x1p-23 : 0x1p-52;
        for (int bin = 0; bin < TALLY_BINS; bin++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                ck_assert_int_eq(bin_of(tier, sign * most[bin] * ulp), bin);
                if (bin > 0)
                    ck_assert_int_eq(bin_of(tier, sign * (most[bin - 1] + 1) * ulp), bin);
            }
        }
    }
    for (int ulps = 0; ulps < 3; ulps++)
        ck_assert_int_eq(bin_of(SURE_TIER_FLOAT32, (ulps + 1) * 0x1p-23 - 0x1p-52), ulps);
}

static tier_tally counted(sure_status truth, sure_status status, sure_part part)
{
    const tally_truth true_one = {.status = truth, .t = right.t, .part = right.part};
    const sure_hit hit = {.t = right.t, .part = part};
    tier_tally sum = {0};
    bool is_right = tally_hit(&sum, SURE_TIER_STABLE, &true_one, status, &hit);
    ck_assert(is_right == (truth == status && part == right.part));
    return sum;
}

TEST(what_is_wrong)
{
    const sure_part part = right.part;
    ck_assert_uint_eq(counted(SURE_MISS, SURE_HIT, part).false_hits, 1);
    ck_assert_uint_eq(counted(SURE_HIT, SURE_MISS, part).false_misses, 1);
    ck_assert_uint_eq(counted(SURE_HIT, SURE_HIT, SURE_PART_BASE).wrong_parts, 1);
    ck_assert_uint_eq(counted(SURE_INVALID, SURE_MISS, part).wrong_validity, 1);
    ck_assert_uint_eq(counted(SURE_HIT, SURE_INVALID, part).wrong_validity, 1);
    const tier_tally none = {0}, missed = counted(SURE_MISS, SURE_MISS, part);
    ck_assert_mem_eq(&missed, &none, sizeof none);
}

/* Each status is counted as what it is, and each count bears its member's name. */
TEST(counts_and_their_names)
{
    static const sure_status seen[] = {SURE_HIT,     SURE_MISS,    SURE_MISS,
                                       SURE_INVALID, SURE_INVALID, SURE_INVALID};
    static const struct {
        const char *name;
        size_t at;
    } named[] = {{"cases", offsetof(pair_tally, cases)},
                 {"hits", offsetof(pair_tally, hits)},
                 {"misses", offsetof(pair_tally, misses)},
                 {"invalid", offsetof(pair_tally, invalid)},
                 {"normals", offsetof(pair_tally, normals)},
                 {"intervals", offsetof(pair_tally, intervals)},
                 {"spawns", offsetof(pair_tally, spawns)},
                 {"no_outside", offsetof(pair_tally, no_outside)},
                 {"no_inside", offsetof(pair_tally, no_inside)},
                 {"out_of_cap", offsetof(pair_tally, out_of_cap)},
                 {"broken", offsetof(pair_tally, broken)},
                 {"float32_false_hits", offsetof(pair_tally, tiers[0].false_hits)},
                 {"stable_false_misses", offsetof(pair_tally, tiers[2].false_misses)},
                 {"certain_wrong_validity", offsetof(pair_tally, tiers[3].wrong_validity)},
                 {"certain_ulps_4", offsetof(pair_tally, tiers[3].ulps[2])},
                 {"exact_exact", offsetof(pair_tally, tiers[4].stages[SURE_STAGES - 1])}};
    pair_tally sum = {0};
    for (size_t i = 0; i < sizeof seen / sizeof *seen; i++)
        tally_truth_seen(&sum, seen[i]);
    ck_assert(sum.cases == 6 && sum.hits == 1 && sum.misses == 2 && sum.invalid == 3);
    for (size_t i = 0; i < sizeof named / sizeof *named; i++)
        ck_assert_str_eq(tally_count_name((int)(named[i].at / sizeof(uint64_t))), named[i].name);
}

SUITE("tally")
