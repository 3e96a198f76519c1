/* SPDX-License-Identifier: MIT */
/* Stands for the capped cylinder of a plain ray tracer. FROZEN (naive.h).
 *
 * The wall's quadratic times N.N, which saves two divisions, with N = top - base, rc = base - o:
 *
 *     a = N.N d.d - (N.d)^2,  b = N.N rc.d - N.d N.rc,  c = N.N (rc.rc - r^2) - (N.rc)^2
 *
 * and the slab t_base = N.rc / N.d, t_top = (N.rc + N.N) / N.d; the chord is in both. */
#include "naive.h"
#include "naive_vector.h"

#include <math.h>

sure_status naive_cylinder_hit(const sure_ray *ray, const sure_cylinder *cylinder, sure_hit *hit)
{
    sure_vec3 d = ray->direction, rc = sub(cylinder->base, ray->origin);
    sure_vec3 n = sub(cylinder->top, cylinder->base);
    double n_n = dot(n, n), n_d = dot(n, d), n_rc = dot(n, rc);
    double a = n_n * dot(d, d) - n_d * n_d;
    double b = n_n * dot(rc, d) - n_d * n_rc;
    double c = n_n * (dot(rc, rc) - cylinder->radius * cylinder->radius) - n_rc * n_rc;
    double quarter = b * b - a * c;
    if (quarter < 0)
        return SURE_MISS;
    double root = sqrt(quarter), over_a = 1 / a, over_n_d = 1 / n_d;
    double wall_enter = (b - root) * over_a, wall_leave = (b + root) * over_a;
    double slab_enter = n_rc * over_n_d, slab_leave = (n_rc + n_n) * over_n_d;
    sure_part first = SURE_PART_BASE, last = SURE_PART_TOP;
    if (n_d < 0) {
        double swapped = slab_enter;
        slab_enter = slab_leave;
        slab_leave = swapped;
        first = SURE_PART_TOP;
        last = SURE_PART_BASE;
    }
    double enter = wall_enter > slab_enter ? wall_enter : slab_enter;
    double leave = wall_leave < slab_leave ? wall_leave : slab_leave;
    if (enter > leave)
        return SURE_MISS;
    double t;
    sure_part part;
    if (enter >= ray->t_min) {
        t = enter;
        part = wall_enter > slab_enter ? SURE_PART_WALL : first;
    } else {
        t = leave;
        part = wall_leave < slab_leave ? SURE_PART_WALL : last;
    }
    if (t < ray->t_min || t > ray->t_max)
        return SURE_MISS;
    hit->t = t;
    hit->part = part;
    return SURE_HIT;
}
