/* SPDX-License-Identifier: MIT */
/* cone_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "cone_filter.h"

static inline lanes_answer cone_lanes(const sure_ray *ray, const sure_cone *cone)
{
    axial_terms of = cone_terms_of(ray, cone);
    cone_ends ends = cone_ends_of(&of, axial_discriminant(&of), of.inner);
    return lanes_capped(&ends.line, &of, cone->radius, ray);
}

LANES_AT_ONCE(cone)

enum { cone_tells_misses = 1 };

/* Whose line certainly passes the wall's body. */
static inline bool cone_lanes_miss(const sure_ray *ray, const sure_cone *cone)
{
    axial_terms of = cone_terms_of(ray, cone);
    double discriminant = axial_discriminant(&of);
    return axial_is_certain(&of, discriminant) & axial_fits(&of, cone->radius) &
           (discriminant < 0) & filter_range(ray);
}
