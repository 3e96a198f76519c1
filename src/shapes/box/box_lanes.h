/* SPDX-License-Identifier: MIT */
/* box_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "box_filter.h"

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
    const sure_vec3 *d = &ray->direction;
    const box_terms of = box_terms_of(ray, box);
    const bool certain = box_in_range(ray, box, &of) & box_is_thick(box);
    box_chord at = box_chord_of(&of);
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
