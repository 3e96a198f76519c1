#include "../geometry/quadratic.h"
#include "check.h"
#include "span.h"

#include <surehit/sphere.h>

/* |o + t d - C|^2 = r^2 with rc = C - o:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 = 0
 *     D/4 = (rc.d)^2 - d.d (rc.rc - r^2)
 *     t   = (rc.d -+ sqrt(D/4)) / d.d
 */
static span sphere_span(const sure_ray *ray, const sure_sphere *sphere)
{
    vec3 rc = vec3_sub(vec3_from(sphere->centre), vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    real r = (real)sphere->radius;
    real roots[2];
    if (!quadratic_roots(vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r, roots))
        return span_empty();
    return span_of(roots[0], roots[1], SURE_PART_SURFACE);
}

SPAN_QUESTIONS(sphere)

sure_vec3 TIER(sure_sphere_normal)(const sure_ray *ray, const sure_sphere *sphere,
                                   const sure_hit *hit)
{
    vec3 outward = span_point(ray, hit->t, sphere->centre);
    return span_normal(outward, sphere->radius > 0, ray);
}
