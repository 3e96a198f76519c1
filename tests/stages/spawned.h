/* SPDX-License-Identifier: MIT */
/* What sure_spawn answers to a hit, on one side. */
#pragma once

#include "../support/answers.h"
#include "../support/every_case.h"
#include "../support/surroundings.h"

typedef struct {
    int found;
    sure_vec3 origin;
} spawned;

static const sure_vec3 untouched = {0x1.5p500, -0x1.5p500, 0x1.7p500};

static inline spawned spawn_in(const sure_case *q, const sure_hit *hit, int side, int surroundings)
{
    spawned s = {.origin = untouched};
    surroundings_set(surroundings);
    s.found = sure_spawn(&q->ray, &q->object, hit, (sure_side)side, &s.origin);
    surroundings_set(0);
    return s;
}

/* To the bit. */
static inline bool same_spawned(const spawned *a, const spawned *b)
{
    return a->found == b->found && memcmp(&a->origin, &b->origin, sizeof a->origin) == 0;
}

static inline const char *text(const sure_case *q, int side)
{
    static char line[CASE_LINE_MAX + 16];
    snprintf(line, sizeof line, "%s, %s", case_text(q), side ? "inside" : "outside");
    return line;
}

/* By certain, of an odd index by exact. */
static inline bool hit_of(const sure_case *q, uint64_t index, sure_hit *hit)
{
    sure_tier tier = index % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
    return sure_object_hit(&q->ray, &q->object, tier, hit) == SURE_HIT;
}
