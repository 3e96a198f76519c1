/* SPDX-License-Identifier: MIT */
/* What makes a number or vector valid. Told by bits, so that it does not matter whether subnormals
 * are taken for zero. */
#pragma once

#include "places.h"

#include <surehit/vector.h>

/* Of no NaNs. */
static inline bool same_number(double a, double b)
{
    return place_of(a) == place_of(b);
}

static inline bool same_point(sure_vec3 a, sure_vec3 b)
{
    return same_number(a.x, b.x) && same_number(a.y, b.y) && same_number(a.z, b.z);
}

static inline bool all_finite(sure_vec3 v)
{
    return is_finite_bits(v.x) && is_finite_bits(v.y) && is_finite_bits(v.z);
}

static inline bool direction_ok(sure_vec3 v)
{
    return all_finite(v) && !(is_zero_bits(v.x) && is_zero_bits(v.y) && is_zero_bits(v.z));
}

static inline bool not_negative(double x)
{
    return !is_negative_bits(x) || is_zero_bits(x);
}

/* No coordinate of low is above that of high. */
static inline bool corners_ok(sure_vec3 low, sure_vec3 high)
{
    return all_finite(high) && place_of(low.x) <= place_of(high.x) &&
           place_of(low.y) <= place_of(high.y) && place_of(low.z) <= place_of(high.z);
}

static inline bool radius_ok(double radius)
{
    return is_finite_bits(radius) && not_negative(radius);
}
