#include "disc.h"
#include "../check.h"

#include <surehit/disc.h>

/* The derivation stands in disc.h. */
static span disc_span(const sure_ray *ray, const sure_disc *disc)
{
    plane_line line = plane_line_from(ray, disc->centre, disc->normal);
    return disc_line_span(&line, (real)disc->radius);
}

static inline bool disc_plain(const sure_ray *ray, const sure_disc *disc, span_first *first)
{
    plane_line line = plane_line_from(ray, disc->centre, disc->normal);
    if (!(flat_surely_valid(ray, line.n_rc, line.n_d) && radius_surely_valid(disc->radius)))
        return false;
    real t = plane_line_t(&line);
    *first = (span_first){disc_holds(&line, t, (real)disc->radius), t, SURE_PART_SURFACE, false};
    return true;
}

SPAN_QUESTIONS(disc)

sure_vec3 TIER(sure_disc_normal)(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(disc->normal)));
}
