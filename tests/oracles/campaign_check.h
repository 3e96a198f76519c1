/* Everything that the tiers certain and exact promise of one case, against the reference. */
#pragma once

#include "campaign_tally.h"

/* Told of each broken promise. */
typedef void campaign_report(const sure_case *question, const char *what);

/* What is checked of a case besides the status, part, field, t and t_error. */
typedef struct {
    bool normal, interval, occluded, spawn; /* normal and spawn: of a hit */
    bool bracket;
    uint64_t parts; /* a draw for the points near a solid's ends; 0: none */
} campaign_more;

/* Counts the case in *sum. */
void campaign_check(const sure_case *question, campaign_more more, campaign_report *report,
                    pair_tally *sum);
