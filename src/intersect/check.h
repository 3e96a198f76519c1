/* Validity, by the contract's table: the first bad field in its order. Told by bits, so that it
 * does not matter whether subnormals are taken for zero. */
#ifndef INTERSECT_CHECK_H
#define INTERSECT_CHECK_H

#include "../arithmetic/bits.h"
#include "../geometry/vec3.h"

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

/* The same for nearly every input at once, from products that a tier's formulas need anyway.
 *
 * <shape>_surely_valid: true only if <shape>_field finds nothing, in any rounding mode, with
 * subnormals taken for zero or not. A sum of squares below infinity has no infinity and no NaN in
 * it; nor has N.d, for infinity * 0 is a NaN. What is above 0 is not all zeros, and a difference
 * that is not 0 is one of different points. In single precision all of these are no less so for
 * the doubles that were rounded. */
static inline bool range_surely_valid(const sure_ray *ray)
{
    return ray->t_min >= 0 && ray->t_min < INFINITY && ray->t_max >= ray->t_min;
}

static inline bool finite_sum(real sum)
{
    return sum < (real)INFINITY;
}

static inline bool plane_surely_valid(const sure_ray *ray, const sure_plane *plane)
{
    vec3 n = vec3_from(plane->normal);
    vec3 rc = vec3_sub(vec3_from(plane->point), vec3_from(ray->origin));
    real n_rc = vec3_dot(n, rc);
    real n_d = vec3_dot(n, vec3_from(ray->direction));
    return n_d != 0 && finite_sum(REAL(fabs)(n_rc) + REAL(fabs)(n_d)) && range_surely_valid(ray);
}

static inline bool disc_surely_valid(const sure_ray *ray, const sure_disc *disc)
{
    vec3 n = vec3_from(disc->normal);
    vec3 rc = vec3_sub(vec3_from(disc->centre), vec3_from(ray->origin));
    real n_rc = vec3_dot(n, rc);
    real n_d = vec3_dot(n, vec3_from(ray->direction));
    real r = (real)disc->radius;
    return n_d != 0 && finite_sum(REAL(fabs)(n_rc) + REAL(fabs)(n_d) + r * r) &&
           disc->radius >= 0 && range_surely_valid(ray);
}

static inline bool sphere_surely_valid(const sure_ray *ray, const sure_sphere *sphere)
{
    vec3 rc = vec3_sub(vec3_from(sphere->centre), vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    real r = (real)sphere->radius;
    real d_d = vec3_dot(d, d);
    return d_d > 0 && finite_sum(d_d + vec3_dot(rc, rc) + r * r) && sphere->radius >= 0 &&
           range_surely_valid(ray);
}

/* `from` is the end point that the formulas see from the origin, `axis` leads from base to top. */
static inline bool axial_surely_valid(const sure_ray *ray, vec3 from, vec3 axis, double radius)
{
    vec3 seen = vec3_sub(from, vec3_from(ray->origin));
    vec3 d = vec3_from(ray->direction);
    real r = (real)radius;
    real d_d = vec3_dot(d, d), n_n = vec3_dot(axis, axis);
    return d_d > 0 && n_n > 0 && finite_sum(d_d + n_n + vec3_dot(seen, seen) + r * r) &&
           radius >= 0 && range_surely_valid(ray);
}

static inline bool cylinder_surely_valid(const sure_ray *ray, const sure_cylinder *cylinder)
{
    vec3 base = vec3_from(cylinder->base);
    return axial_surely_valid(ray, base, vec3_sub(vec3_from(cylinder->top), base),
                              cylinder->radius);
}

static inline bool cone_surely_valid(const sure_ray *ray, const sure_cone *cone)
{
    vec3 apex = vec3_from(cone->apex);
    return axial_surely_valid(ray, apex, vec3_sub(apex, vec3_from(cone->base)), cone->radius);
}

#endif
