/* SPDX-License-Identifier: MIT */
/* The first stage of the plane; docs/proofs/plane_filter.md proves it. With m = o - Q:
 *
 *     h = N.m,  e = N.d,  t = -h / e
 *
 * Vectors are measured by |v|, here the sum of their components' magnitudes: |h| <= |N| |m|. */
#pragma once

#include "../../stages/filter.h"
#ifndef LANES
#include "../../numbers/places.h"
#include "../../stages/decision.h"
#endif

#include <surehit/plane.h>

#include <math.h>

/* Far more than h's products flush, far less than |N| |m|. */
#define FLAT_FLOOR 0x1p-600

/* What is decided on: e, h, m, and the measures |m|, |d| and N's. By its lift a ray that starts
 * beside a plane across an axis is told from one that starts in it. */
typedef struct {
    double e, h;
    double mx, my, mz;
    double reach, stride, normal, steepest; /* steepest: |N| |d|, the most that e can be */
    double lift;                            /* h with its terms made positive, and FLAT_FLOOR */
} flat_terms;

static inline flat_terms flat_terms_of(const sure_ray *ray, const sure_vec3 *place,
                                       const sure_vec3 *normal)
{
    double mx = ray->origin.x - place->x, dx = ray->direction.x, nx = normal->x;
    double my = ray->origin.y - place->y, dy = ray->direction.y, ny = normal->y;
    double mz = ray->origin.z - place->z, dz = ray->direction.z, nz = normal->z;
    double stride = sum_of_magnitudes(dx, dy, dz), size = sum_of_magnitudes(nx, ny, nz);
    return (flat_terms){
        .e = nx * dx + ny * dy + nz * dz,
        .h = nx * mx + ny * my + nz * mz,
        .mx = mx,
        .my = my,
        .mz = mz,
        .reach = sum_of_magnitudes(mx, my, mz),
        .stride = stride,
        .normal = size,
        .steepest = size * stride,
        .lift = sum_of_magnitudes(nx * mx, ny * my, nz * mz) + FLAT_FLOOR,
    };
}

static inline uint64_t flat_scale_bits(const flat_terms *of)
{
    return filter_scale_bits(of->reach, of->stride, of->normal);
}

static inline bool flat_in_range(const flat_terms *of)
{
    return filter_has_scale(flat_scale_bits(of));
}

/* The contract's limit SURE_T_ERROR_CAP for lengths; a sum of magnitudes is up to sqrt(3) times the
 * length, and this is 9/16 of the limit, less than 1/sqrt(3). */
#define FLAT_LIMIT 0x1.2p-25

static inline bool flat_keeps_limit(const flat_terms *of, double error, double size)
{
    return error * of->stride < FLAT_LIMIT * (of->reach + size);
}

/* Where the line crosses the plane: for certain but for flat_in_range and its slope. The error
 * waits for the division, but not for t. */
static inline filter_end flat_place_of(const flat_terms *of)
{
    double per_e = -1 / of->e, share = fabs(per_e);
    double from_h = SURE_CROSSING_T_BOUND * of->lift;
    double from_e = fabs(of->h) * (SURE_CROSSING_T_BOUND * of->steepest);
    return (filter_end){.t = of->h * per_e, .error = (from_h + from_e * share) * share};
}

/* A steep line keeps the limit. */
static inline bool flat_steep(const flat_terms *of)
{
    return fabs(of->e) > SURE_CROSSING_STEEP * of->steepest;
}

/* certain's answer where the line is steep, without a branch: whether there is a hit is as good as
 * random. in_range: flat_in_range and what else the object needs; within, beside: is the crossing
 * then certainly on the surface, or off it? */
typedef struct {
    bool certain, meets, level; /* level: the filter is uncertain, too */
    filter_end at;
} flat_decision;

/* filter_range, but of no range of one point: of one ray alone that is two comparisons. */
static inline bool flat_range(const sure_ray *ray)
{
#ifdef LANES
    return filter_range(ray);
#else
    uint64_t least = bits_of(ray->t_min), most = bits_of(ray->t_max);
    return (least < most) & (most <= FILTER_ENDLESS);
#endif
}

static inline flat_decision flat_decide(const flat_terms *of, bool in_range, bool within,
                                        bool beside, const sure_ray *ray)
{
    filter_end at = flat_place_of(of);
    double deep = filter_lesser(at.t - ray->t_min, ray->t_max - at.t); /* how far in the range */
    bool meets = within & (deep > at.error), misses = beside | (-deep > at.error);
    bool certain = flat_steep(of) & in_range & flat_range(ray) & (meets | misses);
    bool level = (beside ^ true) & (fabs(of->e) <= SURE_CROSSING_SIGN_BOUND * of->steepest);
    return (flat_decision){certain, meets, level, at};
}

static inline flat_decision plane_decide(const sure_ray *ray, const sure_plane *plane)
{
    flat_terms of = flat_terms_of(ray, &plane->point, &plane->normal);
    return flat_decide(&of, flat_in_range(&of), true, true ^ true, ray); /* of lanes, too */
}

#ifndef LANES /* From here on of one ray alone, with branches. */

static inline sure_hit flat_hit_at(const filter_end *at)
{
    return (sure_hit){at->t, at->error, SURE_PART_SURFACE, 0};
}

/* (t_min - t) e */
static inline double flat_late(const flat_terms *of, double t_min)
{
    return of->h + t_min * of->e;
}

/* Is t < t_min? The sign needs no division: a processor that has guessed wrong whether there is a
 * hit learns it that much sooner. Certain when the terms are in range and t_min is valid. Products
 * of a subnormal t_min take some processors a hundred times as long: t < 0 is asked then. */
static inline bool flat_behind(const flat_terms *of, double t_min)
{
    double start = is_subnormal_bits(t_min) ? 0 : t_min;
    double late = flat_late(of, start), most = of->lift + start * of->steepest;
    return (late > 0) == (of->e > 0) && fabs(late) > SURE_CROSSING_BEHIND_BOUND * most &&
           fabs(of->e) > SURE_CROSSING_SIGN_BOUND * of->steepest;
}

static inline filter_verdict flat_found(double t, double error, filter_interval *found)
{
    tagged_end crossed = {END_BASE, SURE_PART_SURFACE};
    filter_end end = {.t = t, .error = error, .end = crossed};
    *found = (filter_interval){end, end};
    return FILTER_INTERVAL;
}

/* size: the object's. */
static inline filter_verdict flat_crossing(const flat_terms *of, double size,
                                           filter_interval *found)
{
    filter_end at = flat_place_of(of);
    if (!flat_steep(of) && !(fabs(of->e) > SURE_CROSSING_CERTAIN * of->steepest &&
                             flat_keeps_limit(of, at.error, size)))
        return FILTER_UNCERTAIN;
    return flat_found(at.t, at.error, found);
}

/* *hit is as it was on anything but FILTER_INTERVAL. */
static inline filter_verdict flat_hit(const flat_decision *said, sure_hit *hit)
{
    if (!said->certain)
        return FILTER_UNCERTAIN;
    hit_where(-(uint64_t)said->meets, flat_hit_at(&said->at), hit);
    return said->meets ? FILTER_INTERVAL : FILTER_MISS;
}

/* FILTER_MISS: the line has no point of the plane from t_min on. */
static INLINED filter_verdict plane_filter(const sure_ray *ray, const void *shape,
                                           filter_interval *found)
{
    const sure_plane *plane = (const sure_plane *)shape;
    flat_terms of = flat_terms_of(ray, &plane->point, &plane->normal);
    if (flat_behind(&of, ray->t_min))
        return filter_miss_if(flat_in_range(&of), ray);
    return flat_in_range(&of) ? flat_crossing(&of, 0, found) : FILTER_UNCERTAIN;
}

/* v.w in twice the precision: off by at most 48 2^-106 |v| |w|, what w is off by as a polish_point
 * included. */
static INLINED dd flat_dot(const sure_vec3 *v, const vector_dd *w)
{
    dd x = two_product(v->x, w->x.head);
    dd y = two_product(v->y, w->y.head);
    dd z = two_product(v->z, w->z.head);
    dd xy = two_sum(x.head, y.head), xyz = two_sum(xy.head, z.head);
    double tails = (x.tail + y.tail) + (z.tail + xy.tail) + xyz.tail;
    double low = v->x * w->x.tail + v->y * w->y.tail + v->z * w->z.tail;
    return (dd){xyz.head, tails + low};
}

/* N.(o + t d - Q) for a point near the plane. */
static inline double plane_residual(const polish_point *p, const sure_vec3 *normal)
{
    vector_dd x = polish_vector(p);
    dd residual = flat_dot(normal, &x);
    return residual.head + residual.tail;
}

static inline polish_step crossing_step(const sure_ray *ray, const sure_vec3 *place,
                                        const sure_vec3 *normal, double t)
{
    const sure_vec3 *d = &ray->direction;
    polish_point p = polish_point_of(ray, place, t);
    double n_most = sum_of_magnitudes(normal->x, normal->y, normal->z);
    double e_most = n_most * sum_of_magnitudes(d->x, d->y, d->z);
    double e = normal->x * d->x + normal->y * d->y + normal->z * d->z;
    double per_e = 1 / e, step = -plane_residual(&p, normal) * per_e;
    double error = fabs(per_e) * (SURE_CROSSING_STEP_BOUND * e_most * fabs(step) +
                                  SURE_CROSSING_RESIDUAL_BOUND * n_most * p.most);
    bool certain =
        fabs(e) > SURE_CROSSING_SLOPE_CERTAIN * e_most && filter_scales(n_most, p.most, fabs(e));
    return (polish_step){step, error, certain};
}

static inline polish_step plane_step(const sure_ray *ray, const void *shape, tagged_end end,
                                     double t)
{
    const sure_plane *plane = (const sure_plane *)shape;
    (void)end;
    return crossing_step(ray, &plane->point, &plane->normal, t);
}

#endif
