/* SPDX-License-Identifier: MIT */
#include "disc.h"
#include "../check.h"

#include <surehit/disc.h>

/* The derivation stands in disc.h. */
static inline span disc_span(const real_ray *ray, const real *of)
{
    plane_line line = plane_line_from(ray, of);
    return disc_line_span(&line, SPAN_NUMBER(of, disc, radius));
}

static inline bool disc_plain(const real_ray *ray, const real *of, span_first *first)
{
    plane_line line = plane_line_from(ray, of);
    if (!(flat_surely_valid(ray, line.n_rc, line.n_d) &&
          radius_surely_valid(SPAN_NUMBER(of, disc, radius))))
        return false;
    real t = plane_line_t(&line);
    *first = (span_first){disc_holds(&line, t, SPAN_NUMBER(of, disc, radius)), t, SURE_PART_SURFACE,
                          false};
    return true;
}

SPAN_QUESTIONS(disc)

sure_vec3 TIER(sure_disc_normal)(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(disc->normal)));
}
