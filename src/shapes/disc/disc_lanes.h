/* SPDX-License-Identifier: MIT */
/* disc_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "disc_filter.h"

static inline lanes_answer disc_lanes(const sure_ray *ray, const sure_disc *disc)
{
    flat_decision said = disc_decide(ray, disc);
    return lanes_planar(&said);
}

LANES_AT_ONCE(disc)

enum { disc_tells_misses = 0 };
#define disc_lanes_miss LANES_NO_MISS
