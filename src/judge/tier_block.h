/* A tier asked many cases, and timed. */
#ifndef JUDGE_TIER_BLOCK_H
#define JUDGE_TIER_BLOCK_H

#include "case.h"

typedef struct {
    sure_status status;
    sure_hit hit;
    sure_vec3 normal;
} tier_answer;

/* Answers all cases, from the first to the last or backwards, with the normals of the hits or
 * without; returns the nanoseconds. */
double tier_block_ask(sure_tier tier, const sure_case *cases, int count, bool normals,
                      bool backwards, tier_answer *answers);

#endif
