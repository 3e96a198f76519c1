/* SPDX-License-Identifier: MIT */
/* certain's answer to one ray before a solid, without a branch: at which end the ray hits, and
 * whether it does, is as good as random. It is filter_first, but the end is chosen first, and what
 * else must be certain is asked of that end alone. docs/proofs/stages.md. */
#pragma once

#include "../numbers/hit.h"
#include "filter.h"

/* The end that the ray hits, if it hits one: the first, or from behind it the second. */
typedef struct {
    uint64_t leaves;       /* all ones: the second */
    double start, t, deep; /* from t_min to the first end; its t; how far that is in the range */
} decision_end;

static INLINED decision_end decision_end_of(double enter, double leave, const sure_ray *ray)
{
    double start = enter - ray->t_min;
    uint64_t leaves = bits_unknown(-(bits_of(start) >> 63));
    double t = filter_either(leaves, leave, enter);
    return (decision_end){leaves, start, t, filter_lesser(t - ray->t_min, ray->t_max - t)};
}

typedef struct {
    bool certain, meets;
    sure_hit hit;
} decided;

/* first_error: of the first end; error: of the one chosen. found: is that certainly an end of the
 * chord, on `part`? none: is there certainly no chord? Not of a range of one point. */
static INLINED decided decision_of(const decision_end *at, double first_error, double error,
                                   bool found, bool none, uint64_t part, const sure_ray *ray)
{
    uint64_t least = bits_of(ray->t_min), most = bits_of(ray->t_max);
    bool chosen = found & (fabs(at->start) > first_error);
    bool meets = chosen & (at->deep > error), misses = none | (chosen & (-at->deep > error));
    return (decided){
        .certain = least < most && most <= FILTER_ENDLESS && bits_unknown(meets | misses) != 0,
        .meets = meets,
        .hit = {at->t, error, (sure_part)part, (int)(at->leaves & 1)},
    };
}

/* Entry: it is certain. */
static INLINED sure_status decision_tell(const decided *said, sure_hit *hit)
{
    hit_where(said->meets, said->hit, hit);
    return said->meets ? SURE_HIT : SURE_MISS;
}
