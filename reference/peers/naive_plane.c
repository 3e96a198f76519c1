/* SPDX-License-Identifier: MIT */
/* Stands for the plane of a plain ray tracer. FROZEN (naive.h).
 *
 *     t = N.rc / N.d,  rc = Q - o */
#include "naive.h"
#include "naive_vector.h"

sure_status naive_plane_hit(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    double n_rc = dot(plane->normal, sub(plane->point, ray->origin));
    double t = n_rc / dot(plane->normal, ray->direction);
    if (!(t >= ray->t_min && t <= ray->t_max))
        return SURE_MISS;
    hit->t = t;
    return SURE_HIT;
}
