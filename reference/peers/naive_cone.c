/* SPDX-License-Identifier: MIT */
/* Stands for the capped cone of a plain ray tracer. FROZEN (naive.h).
 *
 * The wall's quadratic times (N.N)^2, which saves three divisions, with N = apex - base,
 * rq = apex - o, k = N.N + r^2:
 *
 *     a = (N.N)^2 d.d - k (N.d)^2,  b = (N.N)^2 rq.d - k N.rq N.d,  c = (N.N)^2 rq.rq - k (N.rq)^2
 *
 * Where a < 0 the line is in both nappes, beyond the roots; the slab t_apex = N.rq / N.d,
 * t_base = (N.rq - N.N) / N.d keeps the right one. */
#include "naive.h"
#include "naive_vector.h"

#include <math.h>

sure_status naive_cone_hit(const sure_ray *ray, const sure_cone *cone, sure_hit *hit)
{
    sure_vec3 d = ray->direction, rq = sub(cone->apex, ray->origin);
    sure_vec3 n = sub(cone->apex, cone->base);
    double n_n = dot(n, n), n_d = dot(n, d), n_rq = dot(n, rq);
    double k = n_n + cone->radius * cone->radius, n_4 = n_n * n_n;
    double a = n_4 * dot(d, d) - k * n_d * n_d;
    double b = n_4 * dot(rq, d) - k * n_rq * n_d;
    double c = n_4 * dot(rq, rq) - k * n_rq * n_rq;
    double quarter = b * b - a * c;
    if (quarter < 0)
        return SURE_MISS;
    double root = sqrt(quarter), over_a = 1 / a, over_n_d = 1 / n_d;
    double less = (b - root) * over_a, more = (b + root) * over_a;
    double t_apex = n_rq * over_n_d, t_base = (n_rq - n_n) * over_n_d;
    int up = n_d > 0, both_nappes = a < 0;
    double wall_enter = (both_nappes & up) ? -INFINITY : less;
    double wall_leave = (both_nappes & !up) ? INFINITY : more;
    double slab_enter = up ? t_base : t_apex, slab_leave = up ? t_apex : t_base;
    double enter = wall_enter > slab_enter ? wall_enter : slab_enter;
    double leave = wall_leave < slab_leave ? wall_leave : slab_leave;
    if (enter > leave)
        return SURE_MISS;
    double t = enter >= ray->t_min ? enter : leave;
    if (t < ray->t_min || t > ray->t_max)
        return SURE_MISS;
    hit->t = t;
    hit->part = t == t_base ? SURE_PART_BASE : SURE_PART_WALL;
    return SURE_HIT;
}
