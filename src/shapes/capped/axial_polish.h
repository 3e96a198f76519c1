/* SPDX-License-Identifier: MIT */
/* A step towards an end of a cylinder's or cone's chord, in twice the precision;
 * docs/proofs/polish.md has the frame. p is the point seen from base or apex, A the axis: both are
 * sums of two doubles, so are A x p, A.p and what is made of them. docs/proofs/axial_polish.md
 * proves the bounds, which count 2^-53 for an operation. */
#pragma once

#include "../../numbers/sums.h"
#include "../../stages/filter.h"

/* What the line has of an axis: A exactly, d, and p at t. */
typedef struct {
    vector_dd a;
    sure_vec3 d;
    polish_point p;
    double a_most, d_most; /* |A|, |d| or more */
} axial_point;

/* Without d. */
static inline axial_point axial_point_at(const sure_vec3 *from, const sure_vec3 *to, polish_point p)
{
    axial_point at = {.a = vector_between_dd(NULL, *from, *to), .p = p};
    at.a_most = sum_of_magnitudes(at.a.x.head, at.a.y.head, at.a.z.head);
    return at;
}

static inline axial_point axial_point_of(const sure_ray *ray, const sure_vec3 *from,
                                         const sure_vec3 *to, const sure_vec3 *place, double t)
{
    axial_point at = axial_point_at(from, to, polish_point_of(ray, place, t));
    at.d = ray->direction;
    at.d_most = sum_of_magnitudes(at.d.x, at.d.y, at.d.z);
    return at;
}

/* A */
static inline sure_vec3 axial_axis(const axial_point *at)
{
    return (sure_vec3){at->a.x.head, at->a.y.head, at->a.z.head};
}

static inline dd axial_along(const axial_point *at)
{
    dd x = dd_mul(NULL, at->a.x, at->p.x);
    dd y = dd_mul(NULL, at->a.y, at->p.y);
    dd z = dd_mul(NULL, at->a.z, at->p.z);
    return dd_add_loosely(dd_add_loosely(x, y), z);
}

static INLINED dd axial_minor(dd p, dd q, dd r, dd s)
{
    return dd_add_loosely(dd_mul(NULL, p, s), dd_negate(NULL, dd_mul(NULL, q, r)));
}

/* A x p */
static inline vector_dd axial_arm(const axial_point *at)
{
    return (vector_dd){axial_minor(at->a.y, at->a.z, at->p.y, at->p.z),
                       axial_minor(at->a.z, at->a.x, at->p.z, at->p.x),
                       axial_minor(at->a.x, at->a.y, at->p.x, at->p.y)};
}

/* Of dds. */
static INLINED dd axial_square(vector_dd v)
{
    return dd_add_loosely(dd_add_loosely(dd_square(NULL, v.x), dd_square(NULL, v.y)),
                          dd_square(NULL, v.z));
}

/* Where A x p and A.p cancel to less than this share of |A| most, their tails are not small against
 * them: that much is added. */
#define AXIAL_CANCELLED 0x1p-48

static inline double axial_cancelled(const axial_point *at)
{
    return AXIAL_CANCELLED * (at->a_most * at->p.most);
}

/* A x p and A x d, squared and multiplied with each other. */
typedef struct {
    dd square;           /* |A x p|^2 */
    double most, turn;   /* |A x p| + its floor, |A x d|, or more */
    double slope, curve; /* (A x p).(A x d), |A x d|^2 */
} axial_radius;

static inline axial_radius axial_radius_of(const axial_point *at)
{
    vector_dd arm = axial_arm(at);
    sure_vec3 turn = cross_of(axial_axis(at), at->d);
    sure_vec3 p = {dd_value(arm.x), dd_value(arm.y), dd_value(arm.z)};
    return (axial_radius){axial_square(arm), sum_of_magnitudes(p.x, p.y, p.z) + axial_cancelled(at),
                          sum_of_magnitudes(turn.x, turn.y, turn.z), dot(p, turn), dot(turn, turn)};
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
    double e = dot(axial_axis(&at), at.d);
    double around = at.a_most * at.d_most, per_e = 1 / e;
    double step = -dd_value(axial_along(&at)) * per_e;
    double error = fabs(per_e) * (SURE_AXIAL_PLANE_STEP_BOUND * around * fabs(step) +
                                  SURE_AXIAL_PLANE_RESIDUAL_BOUND * at.a_most * at.p.most);
    bool certain = fabs(e) > SURE_AXIAL_PLANE_SLOPE_CERTAIN * around &&
                   filter_scales(at.a_most, at.p.most, fabs(e));
    return (polish_step){step, error, certain};
}
