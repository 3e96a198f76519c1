/* Validity, by the contract's table: the first bad field in its order. */
#ifndef INTERSECT_CHECK_H
#define INTERSECT_CHECK_H

#include <surehit/cone.h>
#include <surehit/cylinder.h>
#include <surehit/disc.h>
#include <surehit/plane.h>
#include <surehit/sphere.h>

#include <math.h>
#include <stdbool.h>

static inline bool all_finite(sure_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static inline bool same_point(sure_vec3 a, sure_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static inline bool direction_ok(sure_vec3 v)
{
    return all_finite(v) && !(v.x == 0 && v.y == 0 && v.z == 0);
}

static inline bool radius_ok(double radius)
{
    return isfinite(radius) && radius >= 0;
}

static inline sure_field ray_field(const sure_ray *ray)
{
    if (!all_finite(ray->origin))
        return SURE_FIELD_O;
    if (!direction_ok(ray->direction))
        return SURE_FIELD_D;
    if (!(isfinite(ray->t_min) && ray->t_min >= 0))
        return SURE_FIELD_T_MIN;
    if (!(ray->t_max >= ray->t_min))
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

#endif
