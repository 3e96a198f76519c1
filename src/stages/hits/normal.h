/* SPDX-License-Identifier: MIT */
/* Normals of `certain` and `exact`. */
#pragma once

#include "surface.h"
#include "../../numbers/sums.h"
#include "../../numbers/valid.h"

#include <surehit/bounds.h>

/* The normal at a hit, beyond a shape's own first stage. Entry: a hit by certain or exact. */
sure_vec3 stages_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, t_wanted wanted);

/* The component of v in which two points differ, where it is the only one; else NULL. */
static inline ddb *surface_level(vector_ddb *v, sure_vec3 from, sure_vec3 to)
{
    bool x = !same_number(to.x, from.x), y = !same_number(to.y, from.y);
    bool z = !same_number(to.z, from.z);
    return x + y + z != 1 ? NULL : x ? &v->x : y ? &v->y : &v->z;
}

/* The first stage of `certain` normals: double arithmetic from the hit's t, where that is good
 * enough for SURE_NORMAL_ERROR. docs/proofs/normals.md proves it. */

/* A length divides well when its square and those of its like are far from the range's ends. */
#define QUICK_LEAST 0x1p-200
#define QUICK_MOST 0x1p200
/* The point is off by this share of |o - from| + |t d| at most, besides t's error. */
#define QUICK_POINT_ROUNDING 0x1p-46
/* What the point may be off by, as a share of its distance from the axis or centre. */
#define QUICK_POINT_SHARE (SURE_NORMAL_ERROR / 8)

static inline bool quick_in_range(double length)
{
    return length > QUICK_LEAST && length < QUICK_MOST;
}

/* v/|v| or its opposite, when |v| is in range. */
static inline bool quick_unit(sure_vec3 v, double sign, sure_vec3 *unit)
{
    double length = sqrt(dot(v, v)), over = sign * length;
    *unit = (sure_vec3){v.x / over, v.y / over, v.z / over};
    return quick_in_range(length);
}

/* The hit point seen from `from` and how far it may be off; false out of range. */
static inline bool quick_point(const sure_ray *ray, const sure_hit *hit, sure_vec3 from,
                               sure_vec3 *p, double *error)
{
    sure_vec3 m = difference_of(ray->origin, from), d = ray->direction;
    double m_length = sqrt(dot(m, m)), d_length = sqrt(dot(d, d));
    *p = sum_of(m, hit->t, d);
    *error = hit->t_error * d_length + QUICK_POINT_ROUNDING * (m_length + hit->t * d_length);
    return quick_in_range(d_length) && m_length < QUICK_MOST && hit->t < QUICK_MOST;
}

/* p less its projection on the axis, seen from a point of the axis. */
static inline sure_vec3 quick_radial(sure_vec3 p, sure_vec3 axis, double height_square)
{
    return sum_of(p, -dot(p, axis) / height_square, axis);
}

/* <shape>_quick_normal: in doubles, from the hit's t, where that is good enough. */
#define SURFACE_NORMALS(shape)                                                                     \
    sure_vec3 sure_##shape##_normal_certain(const sure_ray *ray, const sure_##shape *s,            \
                                            const sure_hit *hit)                                   \
    {                                                                                              \
        sure_vec3 normal;                                                                          \
        if (shape##_quick_normal(ray, s, hit, &normal))                                            \
            return normal;                                                                         \
        return stages_normal(&shape##_row, ray, s, hit, T_CERTAIN);                                \
    }                                                                                              \
    sure_vec3 sure_##shape##_normal_exact(const sure_ray *ray, const sure_##shape *s,              \
                                          const sure_hit *hit)                                     \
    {                                                                                              \
        return stages_normal(&shape##_row, ray, s, hit, T_EXACT);                                  \
    }                                                                                              \
    sure_vec3 sure_##shape##_normal_stable(const sure_ray *ray, const sure_##shape *s,             \
                                           const sure_hit *hit)                                    \
    {                                                                                              \
        sure_vec3 normal;                                                                          \
        if (shape##_quick_normal(ray, s, hit, &normal))                                            \
            return normal;                                                                         \
        return sure_##shape##_normal_textbook(ray, s, hit);                                        \
    }
