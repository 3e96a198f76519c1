/* SPDX-License-Identifier: MIT */
/* What integers modulo 2^128 are, of a known magnitude: signs, double-doubles. */
#pragma once

#include "ddb.h"
#include "mod128.h"

/* Is x, of at most that magnitude, read off its low bits: less than 2^127 units? */
static inline bool mod128_is_whole(double magnitude, mod128 x)
{
    return is_finite_bits(magnitude) && exponent_of(magnitude) + 2 <= x.exponent + MOD128_BITS - 1;
}

/* The sign of x, of at most that magnitude; false where it is not whole. */
static inline bool mod128_sign(double magnitude, mod128 x, int *sign)
{
    *sign = mod128_is_negative(x) ? -1 : !mod128_is_zero(x);
    return mod128_is_whole(magnitude, x);
}

/* The double nearest to x. */
static inline double uint128_rounded(uint128 x)
{
#ifdef __SIZEOF_INT128__
    return (double)x;
#else /* of the first 64 bits, the last of which says whether any follow: 53 are left */
    if (x.high == 0)
        return (double)x.low;
    int unused = 64 - bits_in(x.high);
    uint128 led = uint128_shifted(x, unused);
    return (double)(led.high | (led.low != 0)) * power_of_two(64 - unused);
#endif
}

/* Of a whole number below 2^128. */
static inline uint128 uint128_of(double x)
{
    magnitude_parts parts = parts_of(x);
    return parts.exponent < 0 ? UINT128(0, (uint64_t)x)
                              : uint128_shifted(UINT128(0, parts.mantissa), parts.exponent);
}

/* x, which is whole, as nearly as a double-double can hold it. Entry: round to nearest; the
 * exponent is from -1022 to 800, or x is 0. */
static inline ddb mod128_value(mod128 x)
{
    if (mod128_is_zero(x))
        return (ddb){0, 0, 0};
    bool negative = mod128_is_negative(x);
    mod128 rest = {negative ? uint128_negate(x.low) : x.low, 0};
    double hi = uint128_rounded(rest.low);
    mod128 off = {uint128_add(rest.low, uint128_negate(uint128_of(hi))), 0};
    double lo = mod128_is_negative(off) ? -uint128_rounded(uint128_negate(off.low))
                                        : uint128_rounded(off.low);
    double unit = power_of_two(x.exponent), sign = negative ? -unit : unit;
    double error = fabs(lo) < 0x1p53 ? 0 : DDB_ROUNDING * fabs(lo);
    return ddb_normal(sign * hi, sign * lo, unit * error);
}
