/* SPDX-License-Identifier: MIT */
/* box_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "box_filter.h"

/* box_slab_of; still: the line does not move along the axis. */
static inline box_slab box_lanes_slab(double o, double d, double low, double high, bool *still)
{
    const box_slab along = box_slab_along(o, low, high), across = box_slab_across(o, d, low, high);
    *still = bits_of(d) << 1 == (uint64_t){0};
    return (box_slab){lanes_where(*still, along.near, across.near),
                      lanes_where(*still, along.far, across.far),
                      (*still & along.certain) | (~*still & across.certain)};
}

/* The face that the line enters by. */
static inline uint64_t box_lanes_face(double d, uint64_t low)
{
    return low + (bits_of(d) >> 63);
}

static inline uint64_t box_lanes_part(double end, const double t[3], const uint64_t face[3])
{
    return lanes_where_bits(end == t[0], face[0], lanes_where_bits(end == t[1], face[1], face[2]));
}

static inline lanes_answer box_lanes(const sure_ray *ray, const sure_box *box)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    bool still[3];
    box_terms of = {box_lanes_slab(o->x, d->x, box->low.x, box->high.x, &still[0]),
                    box_lanes_slab(o->y, d->y, box->low.y, box->high.y, &still[1]),
                    box_lanes_slab(o->z, d->z, box->low.z, box->high.z, &still[2])};
    box_chord at = box_chord_of(&of);
    bool certain = box_fits(ray, box, &of) & box_is_thick(box) & ~(still[0] & still[1] & still[2]);
    bool outside = box_misses(&at);
    const uint64_t zero = {0};
    const uint64_t face[] = {box_lanes_face(d->x, zero), box_lanes_face(d->y, zero + 2),
                             box_lanes_face(d->z, zero + 4)};
    const double near[] = {of.x.near, of.y.near, of.z.near};
    const double far[] = {of.x.far, of.y.far, of.z.far};
    lanes_end enter = {at.enter, box_error(at.enter),
                       box_lanes_part(at.enter, near, face) + SURE_PART_X_MIN};
    lanes_end leave = {at.leave, box_error(at.leave),
                       (box_lanes_part(at.leave, far, face) ^ 1) + SURE_PART_X_MIN};
    return lanes_first(certain & ~outside & box_meets(&at), certain & outside, &enter, &leave, ray);
}
