/* Validity, by the contract's table: the first bad field in its order. Told by bits, so that it
 * does not matter whether subnormals are taken for zero. */
#ifndef SHAPES_CHECK_H
#define SHAPES_CHECK_H

#include "../numbers/bits.h"
#include "../numbers/vec3.h"

#include <surehit/cone.h>
#include <surehit/cylinder.h>
#include <surehit/disc.h>
#include <surehit/plane.h>
#include <surehit/sphere.h>

#include <math.h>
#include <stdbool.h>

static inline bool all_finite(sure_vec3 v)
{
    return is_finite_bits(v.x) && is_finite_bits(v.y) && is_finite_bits(v.z);
}

static inline bool same_number(double a, double b)
{
    return bits_of(a) == bits_of(b) || (is_zero_bits(a) && is_zero_bits(b));
}

static inline bool same_point(sure_vec3 a, sure_vec3 b)
{
    return same_number(a.x, b.x) && same_number(a.y, b.y) && same_number(a.z, b.z);
}

static inline bool direction_ok(sure_vec3 v)
{
    return all_finite(v) && !(is_zero_bits(v.x) && is_zero_bits(v.y) && is_zero_bits(v.z));
}

static inline bool not_negative(double x)
{
    return !is_negative_bits(x) || is_zero_bits(x);
}

static inline bool radius_ok(double radius)
{
    return is_finite_bits(radius) && not_negative(radius);
}

static inline sure_field ray_field(const sure_ray *ray)
{
    if (!all_finite(ray->origin))
        return SURE_FIELD_O;
    if (!direction_ok(ray->direction))
        return SURE_FIELD_D;
    if (!(is_finite_bits(ray->t_min) && not_negative(ray->t_min)))
        return SURE_FIELD_T_MIN;
    if (!(magnitude_bits(ray->t_max) <= BITS_INFINITY && not_negative(ray->t_max) &&
          magnitude_bits(ray->t_max) >= magnitude_bits(ray->t_min)))
        return SURE_FIELD_T_MAX;
    return SURE_FIELD_NONE;
}

static inline sure_field plane_field(const sure_ray *ray, const sure_plane *plane)
{
    sure_field bad = ray_field(ray);
    if (bad != SURE_FIELD_NONE)
        return bad;
    if (!all_finite(plane->point))
        return SURE_FIELD_POINT;
    if (!direction_ok(plane->normal))
        return SURE_FIELD_NORMAL;
    return SURE_FIELD_NONE;
}

static inline sure_field disc_field(const sure_ray *ray, const sure_disc *disc)
{
    sure_field bad = ray_field(ray);
    if (bad != SURE_FIELD_NONE)
        return bad;
    if (!all_finite(disc->centre))
        return SURE_FIELD_CENTRE;
    if (!direction_ok(disc->normal))
        return SURE_FIELD_NORMAL;
    if (!radius_ok(disc->radius))
        return SURE_FIELD_RADIUS;
    return SURE_FIELD_NONE;
}

static inline sure_field sphere_field(const sure_ray *ray, const sure_sphere *sphere)
{
    sure_field bad = ray_field(ray);
    if (bad != SURE_FIELD_NONE)
        return bad;
    if (!all_finite(sphere->centre))
        return SURE_FIELD_CENTRE;
    if (!radius_ok(sphere->radius))
        return SURE_FIELD_RADIUS;
    return SURE_FIELD_NONE;
}

static inline sure_field cylinder_field(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sure_field bad = ray_field(ray);
    if (bad != SURE_FIELD_NONE)
        return bad;
    if (!all_finite(cylinder->base))
        return SURE_FIELD_BASE;
    if (!all_finite(cylinder->top) || same_point(cylinder->top, cylinder->base))
        return SURE_FIELD_TOP;
    if (!radius_ok(cylinder->radius))
        return SURE_FIELD_RADIUS;
    return SURE_FIELD_NONE;
}

static inline sure_field cone_field(const sure_ray *ray, const sure_cone *cone)
{
    sure_field bad = ray_field(ray);
    if (bad != SURE_FIELD_NONE)
        return bad;
    if (!all_finite(cone->base))
        return SURE_FIELD_BASE;
    if (!all_finite(cone->apex) || same_point(cone->apex, cone->base))
        return SURE_FIELD_APEX;
    if (!radius_ok(cone->radius))
        return SURE_FIELD_RADIUS;
    return SURE_FIELD_NONE;
}

/* The same for nearly every input at once, from numbers that a tier's formulas need anyway: true
 * only where <shape>_field finds nothing, in any rounding mode, with subnormals taken for zero or
 * not. For what is not finite makes every sum, difference and product of it so, unless it is
 * divided by: infinity times 0 and infinity less infinity are NaNs. In single precision all of
 * this is no less so for the doubles that were rounded. */
static inline bool range_surely_valid(const sure_ray *ray)
{
    uint64_t least = bits_of(ray->t_min), most = bits_of(ray->t_max);
    return least < BITS_INFINITY && least <= most && most <= BITS_INFINITY;
}

static inline bool surely_finite(real x)
{
    return REAL(fabs)(x) < (real)INFINITY;
}

/* Neither zero nor NaN. */
static inline bool surely_not_zero(real x)
{
    return REAL(fabs)(x) > 0;
}

static inline bool radius_surely_valid(double radius)
{
    return bits_of(radius) < BITS_INFINITY;
}

/* With N.rc and N.d, which is not 0 if N = 0 or d = 0. */
static inline bool flat_surely_valid(const sure_ray *ray, real n_rc, real n_d)
{
    return surely_not_zero(n_d) && surely_finite(REAL(fabs)(n_rc) + REAL(fabs)(n_d)) &&
           range_surely_valid(ray);
}

/* With D/4 = (b/2)^2 - a c. Where it is finite, so are a and c; in these, d.d, |rc|^2 and r^2 are
 * terms, and beside them stands (N.rc)^2 / N.N or its like: a NaN for an axis that is not finite
 * or is 0. That d is not 0 the caller knows from another number. */
static inline bool round_surely_valid(const sure_ray *ray, real discriminant, double radius)
{
    return surely_finite(discriminant) && radius_surely_valid(radius) && range_surely_valid(ray);
}

#endif
