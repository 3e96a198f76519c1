/* SPDX-License-Identifier: MIT */
#include "../check.h"
#include "box_filter.h"
#include "box_slabs.h"

/* Ends of the interval across an axis. Where d is 0 they are infinite: of one sign outside of the
 * two planes, of both between them. On one of the planes they are NaNs, as is their product. */
typedef struct {
    real near, far, product;
    bool falling;
} box_ends;

static inline box_ends box_ends_of(real o, real d, real low, real high)
{
    real per_d = 1 / d, t = (low - o) * per_d, u = (high - o) * per_d;
    return (box_ends){span_earlier(t, u), span_later(t, u), t * u, d < 0};
}

/* The first of the faces that are met. */
static inline sure_part box_first(bool on_x, bool x, bool on_y, bool y, bool z)
{
    sure_part other =
        span_either(on_y, (sure_part)(SURE_PART_Y_MIN + y), (sure_part)(SURE_PART_Z_MIN + z));
    return span_either(on_x, (sure_part)(SURE_PART_X_MIN + x), other);
}

static inline bool box_plain(const real_ray *ray, const real *of, span_first *first)
{
    vec3 o = ray->origin, d = ray->direction;
    vec3 low = SPAN_VECTOR(of, box, low), high = SPAN_VECTOR(of, box, high);
    box_ends x = box_ends_of(o.x, d.x, low.x, high.x), y = box_ends_of(o.y, d.y, low.y, high.y);
    box_ends z = box_ends_of(o.z, d.z, low.z, high.z);
    real enter = span_later(span_later(x.near, y.near), z.near);
    real leave = span_earlier(span_earlier(x.far, y.far), z.far);
    real stride = REAL(fabs)(d.x) + REAL(fabs)(d.y) + REAL(fabs)(d.z);
    real all = (o.x + low.x + high.x) + (o.y + low.y + high.y) + (o.z + low.z + high.z) + stride;
    bool ordered = low.x < high.x && low.y < high.y && low.z < high.z; /* as doubles, too */
    if (!(surely_finite(all) && stride > 0 && ordered && enter != leave &&
          !isunordered(x.product, y.product) && z.product == z.product && range_surely_valid(ray)))
        return false;
    bool leaves = enter < ray->t_min;
    sure_part in = box_first(enter == x.near, x.falling, enter == y.near, y.falling, z.falling);
    sure_part out = box_first(leave == x.far, !x.falling, leave == y.far, !y.falling, !z.falling);
    *first = (span_first){.met = enter <= leave,
                          .t = span_chosen(leaves, enter, leave),
                          .part = span_either(leaves, out, in),
                          .leaves = leaves};
    return true;
}

SPAN_QUESTIONS(box)

sure_vec3 TIER(sure_box_normal)(const sure_ray *ray, const sure_box *box, const sure_hit *hit)
{
    (void)ray, (void)box;
    return box_outward(hit->part);
}
