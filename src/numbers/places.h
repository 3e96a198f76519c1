/* SPDX-License-Identifier: MIT */
/* Doubles in their order, by their bits: neighbours and places. */
#pragma once

#include "bits.h"

/* The neighbour of x away from zero. x is finite; DBL_MAX becomes infinite, zero the least
 * subnormal. */
static inline double next_away(double x)
{
    return double_of(bits_of(x) + 1);
}

/* The neighbour of x towards zero. x is neither zero nor NaN. */
static inline double next_towards_zero(double x)
{
    return double_of(bits_of(x) - 1);
}

/* Doubles in their order, as integers: 0 for both zeros. x is no NaN. */
static inline int64_t place_of(double x)
{
    int64_t magnitude = (int64_t)magnitude_bits(x);
    return is_negative_bits(x) ? -magnitude : magnitude;
}

static inline double at_place(int64_t place)
{
    return place < 0 ? double_of((uint64_t)-place | BITS_SIGN) : double_of((uint64_t)place);
}

/* x 2^e, as ldexp has it, which is called only where 2^e is no normal double. */
static inline double times_two_to(double x, int e)
{
    return e >= -1022 && e <= 1023 ? x * power_of_two(e) : ldexp(x, e);
}

/* Zero is not subnormal. */
static inline bool is_subnormal_bits(double x)
{
    return magnitude_bits(x) - 1 < BITS_FRACTION;
}
