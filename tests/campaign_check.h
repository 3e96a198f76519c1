/* Everything that the tiers certain and exact promise of one case, against the reference. */
#ifndef TESTS_CAMPAIGN_CHECK_H
#define TESTS_CAMPAIGN_CHECK_H

#include "campaign_tally.h"

/* Told of each broken promise. */
typedef void campaign_report(const sure_case *question, const char *what);

/* Counts the case in *sum. Status, part, field, t and t_error are checked always; by chance, which
 * `draw` decides, a quarter of the hits' normals, and a sixteenth each of the intervals, of
 * occluded and of the hits' spawns. */
void campaign_check(const sure_case *question, uint64_t draw, campaign_report *report,
                    pair_tally *sum);

#endif
