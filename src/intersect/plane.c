#include "check.h"
#include "plane.h"

#include <surehit/plane.h>

/* The derivation stands in plane.h: t = N.rc / N.d. */
static span plane_span(const sure_ray *ray, const sure_plane *plane)
{
    vec3 rc = vec3_sub(vec3_from(plane->point), vec3_from(ray->origin));
    return plane_line_span(rc, vec3_from(ray->direction), vec3_from(plane->normal));
}

SPAN_QUESTIONS(plane)

sure_vec3 TIER(sure_plane_normal)(const sure_ray *ray, const sure_plane *plane, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(plane->normal)));
}
