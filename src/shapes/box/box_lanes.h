/* SPDX-License-Identifier: MIT */
/* box_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "box_filter.h"

/* A t above it is a single call's to the last bit, where subnormals are flushed, too (box.md). */
#define BOX_UNFLUSHED 0x1p-712

static inline lanes_answer box_lanes(const sure_ray *ray, const sure_box *box)
{
    const box_terms of = box_terms_of(ray, box);
    const bool certain = box_in_range(ray, box) & BOX_TOLD(box_is_crossed(&of) & box_is_thick(box));
    box_chord at = box_chord_of(&of);
    bool outside = box_misses(&at);
    const box_faces faces = box_faces_of(ray, &of, &at);
    lanes_end enter = {at.enter, box_error(at.enter), faces.enter + SURE_PART_X_MIN};
    lanes_end leave = {at.leave, box_error(at.leave), faces.leave + SURE_PART_X_MIN};
    lanes_answer said =
        lanes_first(certain & ~outside & box_meets(&at), certain & outside, &enter, &leave, ray);
    const bool lasts = ~said.hits | (said.t > (double){0} + BOX_UNFLUSHED);
    said.certain &= lasts;
    said.hits &= lasts;
    return said;
}

LANES_AT_ONCE(box)

enum { box_tells_misses = 0 };
#define box_lanes_miss LANES_NO_MISS
