/* SPDX-License-Identifier: MIT */
/* plane_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "plane_filter.h"

static inline lanes_answer plane_lanes(const sure_ray *ray, const sure_plane *plane)
{
    flat_decision said = plane_decide(ray, plane);
    return lanes_planar(&said);
}

LANES_AT_ONCE(plane)

enum { plane_tells_misses = 0 };
#define plane_lanes_miss LANES_NO_MISS
