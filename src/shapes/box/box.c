#include "../check.h"
#include "box_filter.h"
#include "box_slabs.h"

static span box_span(const sure_ray *ray, const sure_box *box)
{
    return box_span_of(ray, box);
}

/* Ends of the interval across an axis, and on which face they are. */
typedef struct {
    real enter, leave;
    sure_part first, last;
} box_ends;

static inline box_ends box_ends_of(real o, real d, real low, real high, sure_part least)
{
    real t = (low - o) / d, u = (high - o) / d;
    bool falling = d < 0;
    return (box_ends){span_chosen(falling, t, u), span_chosen(falling, u, t),
                      (sure_part)(least + falling), (sure_part)(least + !falling)};
}

static inline bool box_plain(const sure_ray *ray, const sure_box *box, span_first *first)
{
    vec3 o = vec3_from(ray->origin), d = vec3_from(ray->direction);
    vec3 low = vec3_from(box->low), high = vec3_from(box->high);
    box_ends x = box_ends_of(o.x, d.x, low.x, high.x, SURE_PART_X_MIN);
    box_ends y = box_ends_of(o.y, d.y, low.y, high.y, SURE_PART_Y_MIN);
    box_ends z = box_ends_of(o.z, d.z, low.z, high.z, SURE_PART_Z_MIN);
    real enter = span_later(span_later(x.enter, y.enter), z.enter);
    real leave = span_earlier(span_earlier(x.leave, y.leave), z.leave);
    real all = x.enter + x.leave + y.enter + y.leave + z.enter + z.leave;
    if (!(surely_finite(all) && surely_finite(d.x + d.y + d.z) && enter != leave &&
          box->low.x <= box->high.x && box->low.y <= box->high.y && box->low.z <= box->high.z &&
          range_surely_valid(ray)))
        return false;
    bool leaves = enter < (real)ray->t_min;
    real t = span_chosen(leaves, enter, leave);
    sure_part at_x = leaves ? x.last : x.first, at_y = leaves ? y.last : y.first;
    sure_part at_z = leaves ? z.last : z.first;
    bool on_x = t == (leaves ? x.leave : x.enter), on_y = t == (leaves ? y.leave : y.enter);
    *first = (span_first){.met = enter <= leave,
                          .t = t,
                          .part = span_either(on_x, at_x, span_either(on_y, at_y, at_z)),
                          .leaves = leaves};
    return true;
}

SPAN_QUESTIONS(box)

sure_vec3 TIER(sure_box_normal)(const sure_ray *ray, const sure_box *box, const sure_hit *hit)
{
    (void)ray, (void)box;
    return box_outward(hit->part);
}
