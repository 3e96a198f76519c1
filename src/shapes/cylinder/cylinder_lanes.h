/* SPDX-License-Identifier: MIT */
/* cylinder_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "cylinder_filter.h"

static inline lanes_answer cylinder_lanes(const sure_ray *ray, const sure_cylinder *cylinder)
{
    axial_terms of = cylinder_terms_of(ray, cylinder);
    cylinder_ends ends = cylinder_ends_of(&of, axial_discriminant(&of), of.inner);
    return lanes_capped(&ends.line, &of, cylinder->radius, ray);
}

LANES_AT_ONCE(cylinder)

enum { cylinder_tells_misses = 0 };
#define cylinder_lanes_miss LANES_NO_MISS
