/* SPDX-License-Identifier: MIT */
/* Stands for the sphere of a plain ray tracer. FROZEN (naive.h).
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 = 0,  rc = C - o */
#include "naive.h"
#include "naive_vector.h"

#include <math.h>

sure_status naive_sphere_hit(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit)
{
    sure_vec3 d = ray->direction, rc = sub(sphere->centre, ray->origin);
    double a = dot(d, d), b = dot(rc, d);
    double c = dot(rc, rc) - sphere->radius * sphere->radius;
    double quarter = b * b - a * c;
    if (quarter < 0)
        return SURE_MISS;
    double root = sqrt(quarter);
    double t = (b - root) / a;
    if (t < ray->t_min)
        t = (b + root) / a;
    if (t < ray->t_min || t > ray->t_max)
        return SURE_MISS;
    hit->t = t;
    return SURE_HIT;
}
