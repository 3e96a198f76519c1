/* What the tiers take for a candidate's cases, so that the times can stand side by side: each runs
 * in a process of its own and is called and timed as a shared library is (plugin.h). */
#ifndef JUDGE_TIER_TIMES_H
#define JUDGE_TIER_TIMES_H

#include "../candidates/candidate.h"

typedef struct tier_times tier_times;

/* NULL: no memory. */
tier_times *tier_times_new(void);
void tier_times_free(tier_times *self);

/* Nanoseconds for the hits of all these cases, and for their normals where those are asked for: the
 * faster of two passes, in an order that nobody has been asked in. 0: not known. */
double tier_times_ask(tier_times *self, sure_tier tier, const block *cases, bool with_normals);

#endif
