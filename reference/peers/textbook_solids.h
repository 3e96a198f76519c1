/* SPDX-License-Identifier: MIT */
/* Cylinder and cone by the quadratic of their wall, an axis of length 1, and discs for caps:
 *
 *     P. J. Schneider, D. H. Eberly: Geometric Tools for Computer Graphics. Morgan Kaufmann 2003,
 *     11.3 (linear components and quadric surfaces)
 *
 * With m = o - base, A the axis, V the apex and w = o - V, in a t^2 + 2 b t + c:
 *
 *     cylinder   a = d.d - (A.d)^2          b = m.d - A.m A.d        c = m.m - (A.m)^2 - r^2
 *     cone       a = (A.d)^2 - k d.d        b = A.d A.w - k d.w      c = (A.w)^2 - k w.w
 *                k = h^2 / (h^2 + r^2)
 *
 * A root counts if its height above the base is between 0 and h, which leaves out the cone's other
 * nappe; a cap if the line meets its plane within the radius; the answer is the least of what is in
 * the range, at a rim the cap.
 *
 * The file that includes this defines how a quadratic is solved. */
#ifndef PEERS_TEXTBOOK_SOLIDS_H
#define PEERS_TEXTBOOK_SOLIDS_H

#include "peer.h"

/* The roots of a t^2 + 2 b t + c, in any order; 0 if there are none. */
static int solve(real a, real b, real c, real roots[2]);

typedef struct {
    const peer_ray *ray;
    vec3 m;                /* origin from the base */
    real height, climb, h; /* A.m, A.d; the solid's height */
    real t;                /* the least so far */
    int part;
} search;

static inline void take(search *all, real t, int part)
{
    if (is_in_range(all->ray, t) && t < all->t) {
        all->t = t;
        all->part = part;
    }
}

static inline void take_wall(search *all, real a, real b, real c)
{
    real roots[2];
    if (!solve(a, b, c, roots))
        return;
    for (int i = 0; i < 2; i++) {
        real above = all->height + roots[i] * all->climb;
        if (above >= 0 && above <= all->h)
            take(all, roots[i], SURE_CANDIDATE_WALL);
    }
}

static inline void take_cap(search *all, vec3 from_centre, real above, real r, int part)
{
    real t = -above / all->climb;
    vec3 p = along(from_centre, t, all->ray->d);
    if (dot(p, p) <= r * r)
        take(all, t, part);
}

/* Base and end are the solid's; the axis, of length 1, is written. */
static inline search search_of(const peer_ray *ray, vec3 base, vec3 end, vec3 *axis)
{
    vec3 n = sub(end, base);
    real h = square_root(dot(n, n));
    *axis = scaled(1 / h, n);
    vec3 m = sub(ray->o, base);
    return (search){ray, m, dot(*axis, m), dot(*axis, ray->d), h, (real)INFINITY, -1};
}

static inline int found_least(const search *all, peer_hit *hit)
{
    return all->part < 0 ? SURE_CANDIDATE_MISS : found(hit, all->t, all->part);
}

static inline int textbook_cylinder(const real *numbers, const real *cylinder, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 top = vector(cylinder + 3), axis, d = ray.d;
    real r = cylinder[6];
    search all = search_of(&ray, vector(cylinder), top, &axis);
    take_cap(&all, all.m, all.height, r, SURE_CANDIDATE_BASE);
    take_cap(&all, sub(ray.o, top), all.height - all.h, r, SURE_CANDIDATE_TOP);
    take_wall(&all, dot(d, d) - all.climb * all.climb, dot(all.m, d) - all.height * all.climb,
              dot(all.m, all.m) - all.height * all.height - r * r);
    return found_least(&all, hit);
}

static inline int textbook_cone(const real *numbers, const real *cone, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 apex = vector(cone + 3), axis, d = ray.d;
    real r = cone[6];
    search all = search_of(&ray, vector(cone), apex, &axis);
    real k = all.h * all.h / (all.h * all.h + r * r);
    vec3 w = sub(ray.o, apex);
    real w_axis = dot(axis, w);
    take_cap(&all, all.m, all.height, r, SURE_CANDIDATE_BASE);
    take_wall(&all, all.climb * all.climb - k * dot(d, d), all.climb * w_axis - k * dot(d, w),
              w_axis * w_axis - k * dot(w, w));
    return found_least(&all, hit);
}

#endif
