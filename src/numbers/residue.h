/* A number known nearly, and also modulo 2^128: of a sum of products of doubles both together
 * often tell everything. The argument is docs/proofs/residue.md. */
#ifndef NUMBERS_RESIDUE_H
#define NUMBERS_RESIDUE_H

#include "modular.h"

typedef near_context residue_context;

#ifdef MODULAR_EXISTS
/* The value is I 2^exponent for an integer I that is low modulo 2^128. */
typedef struct {
    near near;
    modular low;
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
        modular odd = parts.mantissa >> even;
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
static inline modular residue_align(residue x, int exponent)
{
    return modular_shifted(x.low, x.exponent - exponent);
}

static inline residue residue_add(residue_context *context, residue x, residue y)
{
    int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    modular low = residue_align(x, exponent) + residue_align(y, exponent);
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
    return modular_is_whole(fabs(x.near.hi + x.near.lo) + x.near.error, x.exponent);
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
    return modular_value(x.low, x.exponent);
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
