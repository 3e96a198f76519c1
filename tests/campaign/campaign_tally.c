/* SPDX-License-Identifier: MIT */
#include "campaign_tally.h"

#include "tally.h"

#include <stdio.h>
#include <string.h>

enum {
    TIER_COUNTS = sizeof(tier_tally) / sizeof(uint64_t),
    OWN_COUNTS = TALLY_COUNTS - SURE_TIERS * TIER_COUNTS
};

static const char *const own_names[OWN_COUNTS] = {"cases",     "hits",       "misses", "invalid",
                                                  "normals",   "intervals",  "spawns", "no_outside",
                                                  "no_inside", "out_of_cap", "broken"};
static const char *const tier_names[TIER_COUNTS] = {
    "false_hits", "false_misses",  "wrong_parts", "wrong_validity", "ulps_0",
    "ulps_1",     "ulps_4",        "ulps_64",     "ulps_65536",     "ulps_more",
    "double",     "double_double", "mod128",      "exact"};

static const double bins[TALLY_BINS] = {0, 1, 4, 64, 65536, INFINITY};

bool tally_hit(tier_tally *sum, sure_tier tier, const tally_truth *truth, sure_status status,
               const sure_hit *hit)
{
    if ((status == SURE_INVALID) != (truth->status == SURE_INVALID))
        sum->wrong_validity++;
    else if (status != truth->status)
        status == SURE_HIT ? sum->false_hits++ : sum->false_misses++;
    else if (status == SURE_HIT && hit->part != truth->part)
        sum->wrong_parts++;
    else {
        if (status == SURE_HIT) {
            double away = floor(ldexp(error_ulps(hit->t, truth->t, PRECISION_DOUBLE),
                                      tier == SURE_TIER_FLOAT32 ? -29 : 0));
            int bin = 0;
            while (away > bins[bin])
                bin++;
            sum->ulps[bin]++;
        }
        return true;
    }
    return false;
}

void tally_truth_seen(pair_tally *sum, sure_status status)
{
    sum->cases++;
    sum->hits += status == SURE_HIT;
    sum->misses += status == SURE_MISS;
    sum->invalid += status == SURE_INVALID;
}

void pair_tally_add(pair_tally *total, const pair_tally *sum)
{
    for (int i = 0; i < TALLY_COUNTS; i++)
        ((uint64_t *)total)[i] += ((const uint64_t *)sum)[i];
}

const char *tally_count_name(int i)
{
    static char name[64];
    int of_tiers = i - OWN_COUNTS;
    if (of_tiers < 0)
        return own_names[i];
    snprintf(name, sizeof name, "%s_%s", sure_tier_name((sure_tier)(of_tiers / TIER_COUNTS)),
             tier_names[of_tiers % TIER_COUNTS]);
    return name;
}
