/* SPDX-License-Identifier: MIT */
/* What is counted when tiers are held against the truth, in one regime of one shape. */
#pragma once

#include "regimes.h"

#include <surehit/tier.h>

/* Right hits by how far t is from the correctly rounded one, in ulps of the tier's precision: 0, 1,
 * up to 4, up to 64, up to 65536, more. */
#define TALLY_BINS 6

/* Members of both are uint64_t alone: they are added, written and read as arrays. */
typedef struct {
    uint64_t false_hits, false_misses, wrong_parts, wrong_validity;
    uint64_t ulps[TALLY_BINS];
    uint64_t stages[SURE_STAGES]; /* who answered; certain and exact only */
} tier_tally;

typedef struct {
    uint64_t cases, hits, misses, invalid; /* by who knows the truth */
    uint64_t normals, intervals;           /* of the promising tiers, compared */
    uint64_t spawns;                       /* hits where sure_spawn is asked for both sides, ... */
    uint64_t no_outside, no_inside;        /* ... and has none */
    uint64_t out_of_cap;                   /* hits of certain, whose half ulp of t is */
    uint64_t broken;                       /* promises */
    tier_tally tiers[SURE_TIERS];
} pair_tally;

typedef struct {
    sure_status status;
    double t;
    sure_part part;
} tally_truth;

/* Counts the hit that a tier answered. True if status and part are right. */
bool tally_hit(tier_tally *sum, sure_tier tier, const tally_truth *truth, sure_status status,
               const sure_hit *hit);

void tally_truth_seen(pair_tally *sum, sure_status status);
void pair_tally_add(pair_tally *total, const pair_tally *sum);

/* A pair's counts, as they stand in it, and their names: "cases", ..., "float32_false_hits", ...,
 * valid until the next call. */
#define TALLY_COUNTS (int)(sizeof(pair_tally) / sizeof(uint64_t))
const char *tally_count_name(int i);
