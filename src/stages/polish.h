/* A hit's t, correctly rounded: one or two of Newton's steps from the approximation, with the
 * residual in twice the precision, and a bound on what is left. Where the bound does not tell how t
 * is rounded, the next stage does. docs/proofs/polish.md proves the bounds; all count 2^-53 for an
 * operation, so round to nearest is required, but not that subnormals are kept. */
#ifndef STAGES_POLISH_H
#define STAGES_POLISH_H

#include "../numbers/dd.h"
#include "filter.h"

#include <math.h>

/* x = o + t d - from, one component: |x - (head + tail)| <= 4 2^-106 most, |tail| <= 2^-51 most,
 * where most is |o - from| + |t d|. */
typedef struct {
    double head, tail, most;
} polish_component;

static inline polish_component polish_component_of(double o, double from, double t, double d)
{
    dd start = two_sum(o, -from), way = two_product(t, d);
    dd x = two_sum(start.head, way.head);
    return (polish_component){x.head, x.tail + (start.tail + way.tail),
                              fabs(start.head) + fabs(way.head)};
}

typedef struct {
    polish_component x, y, z;
    double most; /* of all three */
} polish_point;

static inline polish_point polish_point_of(const sure_ray *ray, const sure_vec3 *from, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    polish_component x = polish_component_of(o->x, from->x, t, d->x);
    polish_component y = polish_component_of(o->y, from->y, t, d->y);
    polish_component z = polish_component_of(o->z, from->z, t, d->z);
    return (polish_point){x, y, z, x.most + y.most + z.most};
}

static inline dd polish_dd(polish_component x)
{
    return (dd){x.head, x.tail};
}

static inline vector_dd polish_vector(const polish_point *p)
{
    return (vector_dd){polish_dd(p->x), polish_dd(p->y), polish_dd(p->z)};
}

static inline double sum_of_magnitudes(double x, double y, double z)
{
    return fabs(x) + fabs(y) + fabs(z);
}

/* The most that a step may bend, |a step|, as a share of the slope. */
#define POLISH_BEND 0x1p-6

/* |t* - (t + step)| <= error, of which the rounding of step -+ error is a part; when certain. */
typedef struct {
    double step, error;
    bool certain;
} polish_step;

/* t* rounded; true if the error does not matter. Rounding is monotone: what both ends of an
 * interval are rounded to, all of it is, ties and powers of two included. */
static inline bool polish_round(double t, polish_step way, double *rounded)
{
    double low = t + (way.step - way.error), high = t + (way.step + way.error);
    *rounded = low;
    return way.certain && low == high && fabs(low) >= 0x1p-960 && fabs(low) <= 0x1p960;
}

#endif
