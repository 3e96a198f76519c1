/* SPDX-License-Identifier: MIT */
/* Stands for the box of a plain ray tracer. FROZEN (naive.h).
 *
 *     (low - o) / d,  (high - o) / d:  the last to be entered, the first to be left */
#include "naive.h"

#include <math.h>

typedef struct {
    double enter, leave;
    sure_part first, last;
} chord;

static inline void cut(chord *c, double o, double d, double low, double high, sure_part least)
{
    double inverse = 1 / d, near = (low - o) * inverse, far = (high - o) * inverse;
    sure_part near_part = least, far_part = (sure_part)(least + 1);
    if (inverse < 0) {
        double swap = near;
        near = far;
        far = swap;
        near_part = far_part;
        far_part = least;
    }
    if (near > c->enter) {
        c->enter = near;
        c->first = near_part;
    }
    if (far < c->leave) {
        c->leave = far;
        c->last = far_part;
    }
}

sure_status naive_box_hit(const sure_ray *ray, const sure_box *box, sure_hit *hit)
{
    sure_vec3 o = ray->origin, d = ray->direction;
    chord c = {-(double)INFINITY, (double)INFINITY, SURE_PART_X_MIN, SURE_PART_X_MIN};
    cut(&c, o.x, d.x, box->low.x, box->high.x, SURE_PART_X_MIN);
    cut(&c, o.y, d.y, box->low.y, box->high.y, SURE_PART_Y_MIN);
    cut(&c, o.z, d.z, box->low.z, box->high.z, SURE_PART_Z_MIN);
    if (c.enter > c.leave)
        return SURE_MISS;
    double t = c.enter >= ray->t_min ? c.enter : c.leave;
    if (t < ray->t_min || t > ray->t_max)
        return SURE_MISS;
    hit->t = t;
    hit->part = t == c.enter ? c.first : c.last;
    return SURE_HIT;
}
