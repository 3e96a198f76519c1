/* The t of a touch, correctly rounded. Both roots are the vertex -b/a there, and from an
 * approximation t on it is at -s/a, s = a t + b half the body's slope at t: no root, and no
 * residual that vanishes twice. s is a double-double with its running bound, a is rounded. */
#ifndef SHAPES_TOUCH_POLISH_H
#define SHAPES_TOUCH_POLISH_H

#include "../numbers/near.h"
#include "polish.h"

/* What a is off by, at most, as a share of its terms: products of up to four rounded factors, less
 * than 32 2^-53; and of the step the roundings of a sum, a quotient and of step -+ error. */
#define TOUCH_SHARE 0x1p-48

typedef struct {
    near x, y, z;
} touch_vector;

static inline touch_vector touch_of(near_context *c, sure_vec3 v)
{
    return (touch_vector){near_of(c, v.x), near_of(c, v.y), near_of(c, v.z)};
}

static inline touch_vector touch_between(near_context *c, sure_vec3 from, sure_vec3 to)
{
    return (touch_vector){near_difference_of(c, to.x, from.x), near_difference_of(c, to.y, from.y),
                          near_difference_of(c, to.z, from.z)};
}

static inline near touch_dot(near_context *c, touch_vector v, touch_vector w)
{
    near xy = near_add(c, near_mul(c, v.x, w.x), near_mul(c, v.y, w.y));
    return near_add(c, xy, near_mul(c, v.z, w.z));
}

static inline near touch_component(near_context *c, near m, double t, near d)
{
    return near_add(c, m, near_mul(c, near_of(c, t), d));
}

/* o + t d - from */
static inline touch_vector touch_point(near_context *c, const sure_ray *ray, sure_vec3 from,
                                       double t)
{
    touch_vector m = touch_between(c, from, ray->origin), d = touch_of(c, ray->direction);
    return (touch_vector){touch_component(c, m.x, t, d.x), touch_component(c, m.y, t, d.y),
                          touch_component(c, m.z, t, d.z)};
}

/* -s/a rounded on to t, a off by at most TOUCH_SHARE of `most`. */
static inline bool touch_round(double t, near s, double a, double most, double *rounded)
{
    double step = -(s.hi + s.lo) / a, way = fabs(step), off = TOUCH_SHARE * most;
    double error = (s.error + off * way) / (fabs(a) - off) + TOUCH_SHARE * way;
    return polish_round(
        t, (polish_step){step, error * (1 + 0x1p-40), 2 * off < fabs(a) && fabs(t) >= 0x1p-900},
        rounded);
}

#endif
