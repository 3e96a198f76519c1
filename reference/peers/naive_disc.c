/* SPDX-License-Identifier: MIT */
/* Stands for the disc of a plain ray tracer. FROZEN (naive.h).
 *
 *     t = N.rc / N.d,  |t d - rc|^2 <= r^2,  rc = Q - o */
#include "naive.h"
#include "naive_vector.h"

sure_status naive_disc_hit(const sure_ray *ray, const sure_disc *disc, sure_hit *hit)
{
    sure_vec3 d = ray->direction, rc = sub(disc->centre, ray->origin);
    double t = dot(disc->normal, rc) / dot(disc->normal, d);
    if (!(t >= ray->t_min && t <= ray->t_max))
        return SURE_MISS;
    sure_vec3 p = {t * d.x - rc.x, t * d.y - rc.y, t * d.z - rc.z};
    if (dot(p, p) > disc->radius * disc->radius)
        return SURE_MISS;
    hit->t = t;
    return SURE_HIT;
}
