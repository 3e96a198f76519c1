/* What is counted when tiers are held against the reference, in one regime of one shape, and the
 * record of it: a CSV file from which the counting goes on, and of which docs/accuracy.md is
 * made. */
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
    uint64_t cases, hits, misses, invalid; /* by the reference */
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
void tally_add(pair_tally *total, const pair_tally *sum);

/* The record of a seed: one row for each regime that applies to a shape. */
typedef struct {
    uint64_t seed;
    pair_tally pairs[SURE_SHAPES][REGIMES];
} tally_record;

/* False for a file that is there and is no such record; one that is not there is no cases yet. */
bool tally_read(const char *path, tally_record *record);

/* At once or not at all: a new file takes the old one's name. */
bool tally_write(const char *path, const tally_record *record);
