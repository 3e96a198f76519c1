/* SPDX-License-Identifier: MIT */
/* A solid's two end points from its middle, axis and height. */
#pragma once

#include "../../numbers/vec3.h"
#include "../../numbers/valid.h"

/* P, Q = C + t N with |t N| = h/2, so t = +- h/2 sqrt(1 / N.N):
 *
 *     lower = C - h/2 N/|N|,  upper = C + h/2 N/|N|
 *
 * Of the tier's numbers. Returns SURE_FIELD_NONE, or the bad field; `upper_field` is the name of
 * the upper end. */
static inline sure_field end_points(vec3 centre, vec3 axis, real radius, real height,
                                    sure_field upper_field, sure_vec3 *lower, sure_vec3 *upper)
{
    if (!all_finite(vec3_public(centre)))
        return SURE_FIELD_CENTRE;
    if (!direction_ok(vec3_public(axis)))
        return SURE_FIELD_NORMAL;
    vec3 half = vec3_scale(height / 2, vec3_unit(axis));
    sure_vec3 low = vec3_public(vec3_sub(centre, half));
    sure_vec3 high = vec3_public(vec3_add(centre, half));
    if (!(height > 0) || !all_finite(low) || !all_finite(high) || same_point(low, high))
        return upper_field;
    if (!radius_ok(radius))
        return SURE_FIELD_RADIUS;
    *lower = low;
    *upper = high;
    return SURE_FIELD_NONE;
}
