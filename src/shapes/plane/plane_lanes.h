/* SPDX-License-Identifier: MIT */
/* plane_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "plane_filter.h"

static inline lanes_answer plane_lanes(const sure_ray *ray, const sure_plane *plane)
{
    flat_terms of = flat_terms_of(ray, &plane->point, &plane->normal);
    flat_decision said = flat_decide(&of, flat_in_range(&of), true, ~true, ray);
    return lanes_planar(&said);
}
