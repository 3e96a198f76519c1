/* A step towards an end of a cylinder's or cone's chord, in twice the precision; polish.h has the
 * frame. p is the point seen from base or apex, A the axis: both are sums of two doubles, so are
 * A x p, A.p and what is made of them. docs/proofs/axial_polish.md proves the bounds, which count
 * 2^-53 for an operation. */
#pragma once

#include "../../stages/filter.h"

/* What the line has of an axis: A exactly, d, and p at t. */
typedef struct {
    dd ax, ay, az;
    sure_vec3 d;
    polish_point p;
    double a_most, d_most; /* |A|, |d| or more */
} axial_point;

static inline axial_point axial_point_of(const sure_ray *ray, const sure_vec3 *from,
                                         const sure_vec3 *to, const sure_vec3 *place, double t)
{
    axial_point at = {.ax = two_sum(to->x, -from->x),
                      .ay = two_sum(to->y, -from->y),
                      .az = two_sum(to->z, -from->z),
                      .d = ray->direction,
                      .p = polish_point_of(ray, place, t)};
    at.a_most = sum_of_magnitudes(at.ax.head, at.ay.head, at.az.head);
    at.d_most = sum_of_magnitudes(at.d.x, at.d.y, at.d.z);
    return at;
}

static inline dd axial_along(const axial_point *at)
{
    dd x = dd_mul(NULL, at->ax, polish_dd(at->p.x));
    dd y = dd_mul(NULL, at->ay, polish_dd(at->p.y));
    dd z = dd_mul(NULL, at->az, polish_dd(at->p.z));
    return dd_add_loosely(dd_add_loosely(x, y), z);
}

static inline dd axial_minor(dd p, dd q, polish_component r, polish_component s)
{
    return dd_add_loosely(dd_mul(NULL, p, polish_dd(s)),
                          dd_negate(NULL, dd_mul(NULL, q, polish_dd(r))));
}

/* A x p and A x d, squared and multiplied with each other. */
typedef struct {
    dd square;           /* |A x p|^2 */
    double most, turn;   /* |A x p|, |A x d| or more */
    double slope, curve; /* (A x p).(A x d), |A x d|^2 */
} axial_radius;

static inline axial_radius axial_radius_of(const axial_point *at)
{
    dd x = axial_minor(at->ay, at->az, at->p.y, at->p.z);
    dd y = axial_minor(at->az, at->ax, at->p.z, at->p.x);
    dd z = axial_minor(at->ax, at->ay, at->p.x, at->p.y);
    double dx = at->ay.head * at->d.z - at->az.head * at->d.y;
    double dy = at->az.head * at->d.x - at->ax.head * at->d.z;
    double dz = at->ax.head * at->d.y - at->ay.head * at->d.x;
    double px = dd_value(x), py = dd_value(y), pz = dd_value(z);
    return (axial_radius){
        dd_add_loosely(dd_add_loosely(dd_square(NULL, x), dd_square(NULL, y)), dd_square(NULL, z)),
        sum_of_magnitudes(px, py, pz), sum_of_magnitudes(dx, dy, dz), px * dx + py * dy + pz * dz,
        dx * dx + dy * dy + dz * dz};
}

/* H */
static inline dd axial_height(const axial_point *at)
{
    return dd_add_loosely(dd_add_loosely(dd_square(NULL, at->ax), dd_square(NULL, at->ay)),
                          dd_square(NULL, at->az));
}

/* From t on a step^2 + 2 slope step + residual = 0, and the line enters the body where the slope is
 * certainly negative, leaves it where that is positive; `way_out` is the slope where it leaves, and
 * less the slope where it enters. */
static inline polish_step axial_wall_step(const axial_point *at, double residual, double slope,
                                          double way_out, double curve, double measure)
{
    double around = at->a_most * at->d_most * measure, bend = at->a_most * at->d_most;
    double step = -residual * (0.5 / slope), way = fabs(step);
    double error =
        (0.5 / way_out) * (way * (1.5 * curve * way + SURE_AXIAL_STEP_BOUND * around) +
                           SURE_AXIAL_RESIDUAL_BOUND * at->a_most * measure * at->p.most);
    bool certain = way_out > SURE_AXIAL_SLOPE_CERTAIN * around &&
                   curve * way < POLISH_BEND * way_out && filter_scales(bend, measure, way_out);
    return (polish_step){step, error, certain};
}

/* Where the line crosses the plane through `place` across the axis. */
static inline polish_step axial_plane_step(const sure_ray *ray, const sure_vec3 *from,
                                           const sure_vec3 *to, const sure_vec3 *place, double t)
{
    axial_point at = axial_point_of(ray, from, to, place, t);
    double e = at.ax.head * at.d.x + at.ay.head * at.d.y + at.az.head * at.d.z;
    double around = at.a_most * at.d_most, per_e = 1 / e;
    double step = -dd_value(axial_along(&at)) * per_e;
    double error = fabs(per_e) * (SURE_AXIAL_PLANE_STEP_BOUND * around * fabs(step) +
                                  SURE_AXIAL_PLANE_RESIDUAL_BOUND * at.a_most * at.p.most);
    bool certain = fabs(e) > SURE_AXIAL_PLANE_SLOPE_CERTAIN * around &&
                   filter_scales(at.a_most, at.p.most, fabs(e));
    return (polish_step){step, error, certain};
}
