/* SPDX-License-Identifier: MIT */
#include "../numbers/vec3.h"

#include <surehit/bracket.h>

typedef struct {
    sure_implicit *f;
    const void *surface;
    vec3 origin, direction;
} path;

/* f(P_n) > 0: is the point at t outside? */
static int outside(const path *along, real t)
{
    vec3 point = vec3_add(along->origin, vec3_scale(t, along->direction));
    return (real)along->f(along->surface, vec3_public(point)) > 0;
}

/* Halves [t0, t1], outside at t0 only, until no real of the tier lies between: of the reals in
 * between, which are in the order of their bits, whether processors flush the least or not. */
static void halve(const path *along, real *t0, real *t1)
{
    real_bits low = real_bits_of(REAL(fabs)(*t0)), high = real_bits_of(*t1); /* t0 may be -0 */
    while (low + 1 < high) {
        real_bits middle = low + (high - low) / 2;
        if (outside(along, real_of_bits(middle)))
            low = middle;
        else
            high = middle;
    }
    *t0 = real_of_bits(low);
    *t1 = real_of_bits(high);
}

/* Is it a ray in the reals of the tier, too? */
static int is_ray(const path *along, real to)
{
    const vec3 none = vec3_sub(along->origin, along->origin); /* but of infinities */
    return vec3_is_zero(none) && vec3_is_direction(along->direction) && to <= REAL_MAX;
}

/* At a share of the way, and not beyond its end, as roundings might have it. */
static real t_at(real from, real to, real share)
{
    return REAL(fmin)(from + (to - from) * share, to);
}

sure_status TIER(sure_bracket)(sure_implicit *f, const void *surface, const sure_ray *ray,
                               int steps, double t[2])
{
    path along = {f, surface, vec3_from(ray->origin), vec3_from(ray->direction)};
    real from = (real)ray->t_min, to = (real)ray->t_max;
    if (sure_ray_check(ray) != SURE_FIELD_NONE || !is_ray(&along, to) || steps < 1)
        return SURE_INVALID;
    real t0 = from;
    int t0_outside = outside(&along, t0);
    for (int n = 0; n < steps; n++) {
        real t1 = n + 1 == steps ? to : t_at(from, to, (real)(n + 1) / (real)steps);
        int t1_outside = outside(&along, t1);
        if (t0_outside && !t1_outside) {
            halve(&along, &t0, &t1);
            t[0] = t0;
            t[1] = t1;
            return SURE_HIT;
        }
        t0 = t1;
        t0_outside = t1_outside;
    }
    return SURE_MISS;
}
