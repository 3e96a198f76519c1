/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on walls and caps. */
#pragma once

#include "../../numbers/valid.h"
#include "../../stages/hits/spawn_quick.h"
#include "axial_polish.h"

static inline uint64_t axial_beyond(const axial_point *at, double r)
{
    return beyond(at->a_most) | beyond(at->p.most) | beyond(r);
}

/* (A x p) x A */
static inline sure_vec3 radial_of(const axial_point *at)
{
    vector_dd p = axial_arm(at);
    sure_vec3 arm = {dd_value(p.x), dd_value(p.y), dd_value(p.z)};
    return cross_of(arm, axial_axis(at));
}

/* What both walls have, F's terms being of |A| |p| size. The other functions are -A.p and A.p - H.
 */
static inline surface wall_surface(const axial_point *at, double f, double size, double bend,
                                   double height, double depth)
{
    double a = at->a_most, most = at->p.most;
    return (surface){.f = f,
                     .f_error = 0.5 * SURE_AXIAL_RESIDUAL_BOUND * (a * size) * most,
                     .grain = QUICK_SPAWN_SHARE * (a * size + QUICK_SPAWN_SHARE * (bend * most)),
                     .bend = bend,
                     .outward_error = QUICK_SPAWN_OUTWARD * (bend * most),
                     .room = filter_lesser(depth, height - depth) -
                             QUICK_SPAWN_SHARE * (a * (a + most)),
                     .steep = a,
                     .level = {.axis = -1}};
}

/* F = A.p, with A pointing out of the plane at `place` and p seen from there. The other functions
 * are the other plane's and the wall's: |A x p|^2 - r^2 H, or for the cone, with p seen from the
 * apex, |A x p|^2 - r^2 (A.p)^2 / H. */
static inline surface cap_surface(const line_point *line, const sure_vec3 *from,
                                  const sure_vec3 *place, double r)
{
    axial_point at = axial_point_at(from, place, seen_from(place, line));
    dd x = dd_mul(NULL, at.a.x, at.p.x);
    dd y = dd_mul(NULL, at.a.y, at.p.y);
    dd z = dd_mul(NULL, at.a.z, at.p.z);
    sure_vec3 n = axial_axis(&at), arm = cross_of(n, heads_of(&at.p));
    double a = at.a_most, rr = r * r, steep = a * (2 * measure_of(arm) + r * a + 2 * rr);
    double gap = (1 - 4 * QUICK_SPAWN_SHARE) * (rr * dot(n, n)) - dot(arm, arm);
    return (surface){.f = remainder_of(dd_add_loosely(x, y), z),
                     .f_error = SURE_AXIAL_PLANE_RESIDUAL_BOUND * a * at.p.most,
                     .n = n,
                     .room = gap - QUICK_SPAWN_SHARE * (steep * at.p.most),
                     .steep = steep,
                     .beyond = axial_beyond(&at, r),
                     .level =
                         level_of(!same_number(from->x, place->x), !same_number(from->y, place->y),
                                  !same_number(from->z, place->z), n, place)};
}

static inline bool spawn_on_cap(const sure_ray *ray, const sure_hit *hit, double side,
                                const sure_vec3 *from, const sure_vec3 *place, double r,
                                sure_vec3 *origin, sure_hit *nearer)
{
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line, cap_surface(&line, from, place, r), origin,
                            nearer);
}

/* <shape>_spawn_quick, from <shape>_surface for the wall. */
#define CAPPED_SPAWN(solid, solid_has_top)                                                         \
    SPAWN_QUICK(solid##_spawn_on_wall, solid##_surface(&line, shape))                              \
    static inline bool solid##_spawn_quick(const sure_ray *ray, const void *shape,                 \
                                           const sure_hit *hit, double side, sure_vec3 *origin,    \
                                           sure_hit *nearer)                                       \
    {                                                                                              \
        const sure_##solid *s = shape;                                                             \
        const sure_vec3 *ends = shape;                                                             \
        bool top = solid_has_top && hit->part == SURE_PART_TOP;                                    \
        if (hit->part == SURE_PART_WALL)                                                           \
            return solid##_spawn_on_wall(ray, shape, hit, side, origin, nearer);                   \
        return spawn_on_cap(ray, hit, side, &ends[!top], &ends[top], s->radius, origin, nearer);   \
    }
