#include "../geometry/quadratic.h"
#include "check.h"
#include "plane.h"

#include <surehit/disc.h>

/* The plane of the disc, then the distance from its centre Q, rc = Q - o:
 *
 *     t = N.rc / N.d,  |t d - rc|^2 <= r^2
 *
 * A line in the plane cuts the chord |t d - rc|^2 <= r^2 from the disc:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 <= 0
 */
static span disc_span(const sure_ray *ray, const sure_disc *disc)
{
    vec3 rc = vec3_sub(vec3_from(disc->centre), vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    real r = (real)disc->radius;
    span line = plane_line_span(rc, d, vec3_from(disc->normal));
    if (line.boundary) {
        real roots[2];
        if (!quadratic_roots(vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r, roots))
            return span_empty();
        line.enter = roots[0];
        line.leave = roots[1];
        line.endless = false;
        return line;
    }
    vec3 from_centre = vec3_sub(vec3_scale(line.enter, d), rc);
    return vec3_dot(from_centre, from_centre) <= r * r ? line : span_empty();
}

SPAN_QUESTIONS(disc)

sure_vec3 TIER(sure_disc_normal)(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    (void)ray;
    (void)hit;
    return vec3_public(vec3_unit(vec3_direction_from(disc->normal)));
}
