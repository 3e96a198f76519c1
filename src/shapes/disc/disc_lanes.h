/* SPDX-License-Identifier: MIT */
/* disc_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "disc_filter.h"

static inline lanes_answer disc_lanes(const sure_ray *ray, const sure_disc *disc)
{
    flat_terms of = flat_terms_of(ray, &disc->centre, &disc->normal);
    disc_foot_terms foot = disc_foot_terms_of(&of, ray, disc->radius);
    flat_decision said =
        flat_decide(&of, foot.in_range, disc_inside(&foot), disc_outside(&foot), ray);
    return lanes_planar(&said);
}
