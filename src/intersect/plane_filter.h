/* The first stage of the plane; docs/proofs/plane_filter.md proves it. With m = o - Q:
 *
 *     h = N.m,  e = N.d,  t = -h / e
 *
 * Vectors are measured by |v|, here the sum of their components' magnitudes: |h| <= |N| |m|. */
#ifndef INTERSECT_PLANE_FILTER_H
#define INTERSECT_PLANE_FILTER_H

#include "polish.h"

#include <surehit/plane.h>

#include <math.h>

/* Where a line crosses a plane, and what else the disc needs: |m|, |d| and N's. */
typedef struct {
    double t, error;
    double mx, my, mz;
    double reach, stride, normal;
    bool certain; /* but for filter_scales(reach, stride, normal) and crossing_keeps_limit */
} crossing;

static inline crossing plane_crossing(const sure_ray *ray, const sure_vec3 *place,
                                      const sure_vec3 *normal)
{
    double mx = ray->origin.x - place->x, dx = ray->direction.x, nx = normal->x;
    double my = ray->origin.y - place->y, dy = ray->direction.y, ny = normal->y;
    double mz = ray->origin.z - place->z, dz = ray->direction.z, nz = normal->z;
    double e = nx * dx + ny * dy + nz * dz, h = nx * mx + ny * my + nz * mz;
    double reach = sum_of_magnitudes(mx, my, mz), stride = sum_of_magnitudes(dx, dy, dz);
    double size = sum_of_magnitudes(nx, ny, nz), per_e = 1 / e, t = -h * per_e;
    double error = SURE_CROSSING_T_BOUND * size * fabs(per_e) * (reach + fabs(t) * stride);
    return (crossing){
        t, error, mx, my, mz, reach, stride, size, fabs(e) > SURE_CROSSING_CERTAIN * size * stride};
}

/* A sum of magnitudes is up to sqrt(3) times the length: this is 9/16 < 1/sqrt(3) of the contract's
 * limit. */
static inline bool crossing_keeps_limit(const crossing *at, double size)
{
    return at->error * at->stride < 0x1.2p-25 * (at->reach + size);
}

static inline filter_verdict crossing_found(const crossing *at, filter_chord *found)
{
    chord_end crossed = {POINT_BASE, SURE_PART_SURFACE};
    filter_end end = {.t = at->t, .error = at->error, .end = crossed};
    *found = (filter_chord){end, end};
    return FILTER_CHORD;
}

static inline filter_verdict plane_filter(const sure_ray *ray, const sure_plane *plane,
                                          filter_chord *found)
{
    crossing at = plane_crossing(ray, &plane->point, &plane->normal);
    if (!(at.certain && crossing_keeps_limit(&at, 0) &&
          filter_scales(at.reach, at.stride, at.normal)))
        return FILTER_UNCERTAIN;
    return crossing_found(&at, found);
}

/* N.(o + t d - Q) for a point near the plane, in twice the precision: off by at most 48 2^-106
 * times |N| |x|. */
static inline double plane_residual(const polish_point *p, const sure_vec3 *normal)
{
    double_pair x = two_product(normal->x, p->x.head);
    double_pair y = two_product(normal->y, p->y.head);
    double_pair z = two_product(normal->z, p->z.head);
    double_pair xy = two_sum(x.head, y.head), xyz = two_sum(xy.head, z.head);
    double tails = (x.tail + y.tail) + (z.tail + xy.tail) + xyz.tail;
    double low = normal->x * p->x.tail + normal->y * p->y.tail + normal->z * p->z.tail;
    return xyz.head + (tails + low);
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

/* t* correctly rounded, or false. end: a crossing known to be the answer, its t nearly known.
 * Entry: round to nearest. */
static inline bool plane_polish(const sure_ray *ray, const sure_plane *plane, const filter_end *end,
                                double *t)
{
    return polish_round(end->t, crossing_step(ray, &plane->point, &plane->normal, end->t), t);
}

#endif
