/* SPDX-License-Identifier: MIT */
/* The stable tier's powers of two: taken out of a problem, exactly, where products of its numbers
 * would leave the range of double, and only there. */
#pragma once

#include "vec3.h"

#include <stdbool.h>

/* Of a number that is at most 2^100 in magnitude, by its square. Products of eight such numbers do
 * not overflow, and those of eight that are at least 2^-100 do not underflow. */
static inline bool scale_is_moderate(real square)
{
    return square >= 0x1p-200 && square <= 0x1p200;
}

/* Of what is above 0: has it neither over- nor underflowed? */
static inline bool scale_is_in_range(real x)
{
    return x >= REAL_MIN_NORMAL && x <= REAL_MAX;
}

static inline real scale_larger(real x, real y)
{
    return x > y ? x : y;
}

static inline real scale_largest(vec3 v)
{
    return scale_larger(REAL(fabs)(v.x), scale_larger(REAL(fabs)(v.y), REAL(fabs)(v.z)));
}

/* e with x in [2^(e-1), 2^e); 0 for zero. */
static inline int scale_exponent(real x)
{
    int exponent;
    (void)REAL(frexp)(x, &exponent);
    return exponent;
}

static inline vec3 scale_vector(vec3 v, int exponent)
{
    return (vec3){REAL(ldexp)(v.x, exponent), REAL(ldexp)(v.y, exponent),
                  REAL(ldexp)(v.z, exponent)};
}

static inline bool scale_is_finite(vec3 v)
{
    return v.x - v.x == 0 && v.y - v.y == 0 && v.z - v.z == 0;
}

/* unit (to - from), the unit a power of two. */
static inline vec3 scale_between(sure_vec3 from, sure_vec3 to, real unit)
{
    return vec3_sub(vec3_scale(unit, vec3_from(to)), vec3_scale(unit, vec3_from(from)));
}

/* The unit in which the way from one point to another is finite; the other tiers let it overflow.
 */
static inline real scale_unit(sure_vec3 from, sure_vec3 to)
{
#ifdef SURE_STABLE
    return scale_is_finite(scale_between(from, to, 1)) ? 1 : 0.25;
#else
    (void)from;
    (void)to;
    return 1;
#endif
}

/* The way in that unit, for where only its direction counts. */
static inline vec3 scale_way(sure_vec3 from, sure_vec3 to)
{
    return scale_between(from, to, scale_unit(from, to));
}
