/* The t of a tangent point, correctly rounded. Both roots are the vertex -b/a there, and from an
 * approximation t on it is at -s/a, s = a t + b half the body's slope at t: no root, and no
 * residual that vanishes twice. s is a double-double with its running bound, a is rounded. */
#ifndef STAGES_TANGENT_H
#define STAGES_TANGENT_H

#include "../numbers/mod128.h"
#include "polish.h"

/* What a is off by, at most, as a share of its terms: products of up to four rounded factors, less
 * than 32 2^-53; and of the step the roundings of a sum, a quotient and of step -+ error. */
#define TANGENT_SHARE 0x1p-48

/* What the slope a x + b is off by in doubles, at most, as a share of its measure times |p| |d|,
 * and what is flushed. */
#define TANGENT_SLOPE_SHARE 0x1p-44
#define TANGENT_SLOPE_FLOOR 0x1p-471

#ifdef MOD128_EXISTS
/* The sign of t* - x = -(a x + b) / a for a tangent point, where a > 0: of a slope that is nearly
 * `slope`, whose terms have that measure for |p| |d|, p at x. */
static inline bool tangent_order_of(const sure_ray *ray, sure_vec3 from, double x, double slope,
                                    double measure, mod128 low, int *sign)
{
    const sure_vec3 *d = &ray->direction, *o = &ray->origin;
    double step = sum_of_magnitudes(d->x, d->y, d->z);
    double m = sum_of_magnitudes(o->x - from.x, o->y - from.y, o->z - from.z);
    double off = TANGENT_SLOPE_SHARE * (measure * (m + fabs(x) * step) * step);
    double most = fabs(slope) + off + TANGENT_SLOPE_FLOOR;
    bool known = mod128_sign(most, low, sign);
    *sign = -*sign;
    return known;
}
#endif

/* o + t d - from */
static inline vector_ddb tangent_point(ddb_context *c, const sure_ray *ray, sure_vec3 from,
                                       double t)
{
    vector_ddb m = vector_between_ddb(c, from, ray->origin);
    vector_ddb d = vector_of_ddb(c, ray->direction);
    return vector_add_ddb(c, m, vector_scale_ddb(c, ddb_of(c, t), d));
}

/* -s/a rounded on to t, a off by at most TANGENT_SHARE of `most`. */
static inline bool tangent_round(double t, ddb s, double a, double most, double *rounded)
{
    double step = -(s.hi + s.lo) / a, way = fabs(step), off = TANGENT_SHARE * most;
    double error = (s.error + off * way) / (fabs(a) - off) + TANGENT_SHARE * way;
    return polish_round(
        t, (polish_step){step, error * (1 + 0x1p-40), 2 * off < fabs(a) && fabs(t) >= 0x1p-900},
        rounded);
}

#endif
