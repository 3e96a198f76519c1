/* A number known nearly, and also modulo 2^128: of a sum of products of doubles both together
 * often tell everything. The argument is docs/proofs/residue.md. */
#ifndef ARITHMETIC_RESIDUE_H
#define ARITHMETIC_RESIDUE_H

#include "near.h"

typedef near_context residue_context;

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 residue_word;

/* The value is I 2^exponent for an integer I that is low modulo 2^128. */
typedef struct {
    near near;
    residue_word low;
    int exponent;
} residue;

/* Zero is a multiple of every power of two: larger than any exponent that arises, and such that a
 * product of a thousand zeros is in range. */
#define RESIDUE_EXPONENT_OF_ZERO (1 << 20)

static inline residue residue_of(residue_context *context, double x)
{
    magnitude_parts parts = parts_of(x);
    residue z = {near_of(context, x), 0, RESIDUE_EXPONENT_OF_ZERO};
    if (parts.mantissa != 0) {
        int even = __builtin_ctzll(parts.mantissa);
        residue_word odd = parts.mantissa >> even;
        z.low = is_negative_bits(x) ? -odd : odd;
        z.exponent = parts.exponent + even;
    }
    return z;
}

static inline residue residue_negate(residue_context *context, residue x)
{
    return (residue){near_negate(context, x.near), -x.low, x.exponent};
}

/* low as it is when counted in units of 2^exponent, which is not above x.exponent. */
static inline residue_word residue_align(residue x, int exponent)
{
    int shift = x.exponent - exponent;
    return shift < 128 ? x.low << shift : 0;
}

static inline residue residue_add(residue_context *context, residue x, residue y)
{
    int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    residue_word low = residue_align(x, exponent) + residue_align(y, exponent);
    return (residue){near_add(context, x.near, y.near), low, exponent};
}

static inline residue residue_sub(residue_context *context, residue x, residue y)
{
    return residue_add(context, x, residue_negate(context, y));
}

/* x - y, its near part exactly. */
static inline residue residue_difference_of(residue_context *context, double x, double y)
{
    residue z = residue_sub(context, residue_of(context, x), residue_of(context, y));
    z.near = near_difference_of(context, x, y);
    return z;
}

static inline residue residue_mul(residue_context *context, residue x, residue y)
{
    return (residue){near_mul(context, x.near, y.near), x.low * y.low, x.exponent + y.exponent};
}

static inline residue residue_square(residue_context *context, residue x)
{
    return (residue){near_square(context, x.near), x.low * x.low, 2 * x.exponent};
}

/* Is |value| < 2^(exponent + 127), so that I is low read as a signed integer? */
static inline bool residue_is_whole(residue x)
{
    double most = fabs(x.near.hi + x.near.lo) + x.near.error;
    return is_finite_bits(most) && exponent_of(most) + 2 <= x.exponent + 127;
}

static inline int residue_sign(residue_context *context, residue x)
{
    near_context alone = {false};
    int sign = near_sign(&alone, x.near);
    if (!alone.uncertain)
        return sign;
    if (!residue_is_whole(x)) {
        context->uncertain = true;
        return 0;
    }
    return x.low >> 127 != 0 ? -1 : x.low != 0;
}

/* The same number as nearly as a double-double can hold it, where the residue is all of it. */
static inline near residue_value(residue x)
{
    if (!residue_is_whole(x) || x.exponent < -1022 || x.exponent > 800)
        return x.low == 0 && residue_is_whole(x) ? (near){0, 0, 0} : x.near;
    bool negative = x.low >> 127 != 0;
    residue_word rest = negative ? -x.low : x.low;
    double hi = (double)rest;
    bool above = (residue_word)hi > rest;
    double lo = above ? -(double)((residue_word)hi - rest) : (double)(rest - (residue_word)hi);
    double unit = power_of_two(x.exponent), sign = negative ? -unit : unit;
    double error = fabs(lo) < 0x1p53 ? 0 : NEAR_ROUNDING * fabs(lo);
    return near_normal(sign * hi, sign * lo, unit * error);
}

#else

/* Without 128-bit integers: the near number alone. */
typedef struct {
    near near;
} residue;

static inline residue residue_of(residue_context *context, double x)
{
    return (residue){near_of(context, x)};
}

static inline residue residue_negate(residue_context *context, residue x)
{
    return (residue){near_negate(context, x.near)};
}

static inline residue residue_add(residue_context *context, residue x, residue y)
{
    return (residue){near_add(context, x.near, y.near)};
}

static inline residue residue_sub(residue_context *context, residue x, residue y)
{
    return (residue){near_sub(context, x.near, y.near)};
}

static inline residue residue_difference_of(residue_context *context, double x, double y)
{
    return (residue){near_difference_of(context, x, y)};
}

static inline residue residue_mul(residue_context *context, residue x, residue y)
{
    return (residue){near_mul(context, x.near, y.near)};
}

static inline residue residue_square(residue_context *context, residue x)
{
    return (residue){near_square(context, x.near)};
}

static inline int residue_sign(residue_context *context, residue x)
{
    return near_sign(context, x.near);
}

static inline near residue_value(residue x)
{
    return x.near;
}

#endif
#endif
