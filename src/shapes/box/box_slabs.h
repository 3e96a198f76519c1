/* SPDX-License-Identifier: MIT */
/* What the planes across each axis leave of the line, as the tier has it: the intersection of slabs
 * (Kay and Kajiya 1986). */
#pragma once

#include "../span.h"

#include <surehit/box.h>

static inline span box_span_along(real o, real low, real high, sure_part least)
{
    bool on_low = o == low, on_high = o == high;
    if (!(low <= o && o <= high))
        return span_empty();
    return span_line(on_low || !on_high ? least : (sure_part)(least + 1), on_low || on_high);
}

static inline span box_span_across(real o, real d, real low, real high, sure_part least)
{
    if (d == 0)
        return box_span_along(o, low, high, least);
    real per_d = 1 / d;
    const real t[2] = {(low - o) * per_d, (high - o) * per_d};
    bool falling = d < 0;
    span slab = span_of(t[falling], t[!falling], least);
    slab.enter_part = (sure_part)(least + falling);
    slab.leave_part = (sure_part)(least + !falling);
    return slab;
}

/* On an edge the first axis counts: it is the slab of the two. */
static INLINED span box_span(const real_ray *ray, const real *of)
{
    vec3 o = ray->origin, d = ray->direction;
    vec3 low = SPAN_VECTOR(of, box, low), high = SPAN_VECTOR(of, box, high);
    span x = box_span_across(o.x, d.x, low.x, high.x, SURE_PART_X_MIN);
    span y = box_span_across(o.y, d.y, low.y, high.y, SURE_PART_Y_MIN);
    span z = box_span_across(o.z, d.z, low.z, high.z, SURE_PART_Z_MIN);
    return span_within(span_within(z, y), x);
}
