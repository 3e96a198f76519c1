/* The first stage of `certain` normals: double arithmetic from the hit's t, where that is good
 * enough for SURE_NORMAL_ERROR. docs/proofs/normals.md proves it. */
#ifndef STAGES_NORMAL_QUICK_H
#define STAGES_NORMAL_QUICK_H

#include "../filter.h"

#include <surehit/bounds.h>

/* A length divides well when its square and those of its like are far from the range's ends. */
#define QUICK_LEAST 0x1p-200
#define QUICK_MOST 0x1p200
/* The point is off by this share of |o - from| + |t d| at most, besides t's error. */
#define QUICK_POINT_ROUNDING 0x1p-46
/* What the point may be off by, as a share of its distance from the axis or centre. */
#define QUICK_POINT_SHARE (SURE_NORMAL_ERROR / 8)

typedef struct {
    double x, y, z;
} quick_vector;

static inline quick_vector quick_between(sure_vec3 from, sure_vec3 to)
{
    return (quick_vector){to.x - from.x, to.y - from.y, to.z - from.z};
}

static inline double quick_dot(quick_vector v, quick_vector w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

/* v + k w */
static inline quick_vector quick_plus(quick_vector v, double k, quick_vector w)
{
    return (quick_vector){v.x + k * w.x, v.y + k * w.y, v.z + k * w.z};
}

static inline bool quick_in_range(double length)
{
    return length > QUICK_LEAST && length < QUICK_MOST;
}

/* v / length */
static inline sure_vec3 quick_over(quick_vector v, double length)
{
    return (sure_vec3){v.x / length, v.y / length, v.z / length};
}

/* v/|v| or its opposite, when |v| is in range. */
static inline bool quick_unit(quick_vector v, double sign, sure_vec3 *unit)
{
    double length = sqrt(quick_dot(v, v));
    *unit = quick_over(v, sign * length);
    return quick_in_range(length);
}

/* The hit point seen from `from` and how far it may be off; false out of range. */
static inline bool quick_point(const sure_ray *ray, const sure_hit *hit, sure_vec3 from,
                               quick_vector *p, double *error)
{
    quick_vector m = quick_between(from, ray->origin);
    quick_vector d = {ray->direction.x, ray->direction.y, ray->direction.z};
    double m_length = sqrt(quick_dot(m, m)), d_length = sqrt(quick_dot(d, d));
    *p = quick_plus(m, hit->t, d);
    *error = hit->t_error * d_length + QUICK_POINT_ROUNDING * (m_length + hit->t * d_length);
    return quick_in_range(d_length) && m_length < QUICK_MOST && hit->t < QUICK_MOST;
}

/* p less its projection on the axis, seen from a point of the axis. */
static inline quick_vector quick_radial(quick_vector p, quick_vector axis, double height_square)
{
    return quick_plus(p, -quick_dot(p, axis) / height_square, axis);
}

#endif
