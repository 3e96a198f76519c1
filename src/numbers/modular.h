/* Integers modulo 2^128, counted in a unit: of a polynomial of doubles the last digits, exactly. A
 * number that is known to be less than 2^127 units is known completely (docs/proofs/residue.md). */
#ifndef NUMBERS_MODULAR_H
#define NUMBERS_MODULAR_H

#include "near.h"

#ifdef __SIZEOF_INT128__
#define MODULAR_EXISTS
__extension__ typedef unsigned __int128 modular;

/* Of which power of two the numbers of one kind are multiples. */
typedef struct {
    int exponent;
} modular_context;

/* The unit of no number but zeros: above any other, and far enough from overflow when added up. */
#define MODULAR_UNIT_OF_ZEROS 4096

/* Makes the unit fit for x as well. x is finite. */
static inline void modular_fit(modular_context *unit, double x)
{
    magnitude_parts parts = parts_of(x);
    if (parts.mantissa == 0)
        return;
    int least = parts.exponent + __builtin_ctzll(parts.mantissa);
    unit->exponent = least < unit->exponent ? least : unit->exponent;
}

static inline modular modular_shifted(modular x, int places)
{
    return places < 128 ? x << places : 0;
}

/* x, for which the unit is fit. */
static inline modular modular_of(modular_context *unit, double x)
{
    magnitude_parts parts = parts_of(x);
    if (parts.mantissa == 0)
        return 0;
    int even = __builtin_ctzll(parts.mantissa);
    modular odd = parts.mantissa >> even;
    odd = modular_shifted(odd, parts.exponent + even - unit->exponent);
    modular negative = -(modular)is_negative_bits(x); /* signs are as good as random: no branch */
    return (odd ^ negative) - negative;
}

static inline modular modular_difference_of(modular_context *unit, double x, double y)
{
    return modular_of(unit, x) - modular_of(unit, y);
}

static inline modular modular_negate(modular_context *unit, modular x)
{
    (void)unit;
    return -x;
}

static inline modular modular_add(modular_context *unit, modular x, modular y)
{
    (void)unit;
    return x + y;
}

static inline modular modular_sub(modular_context *unit, modular x, modular y)
{
    (void)unit;
    return x - y;
}

static inline modular modular_mul(modular_context *unit, modular x, modular y)
{
    (void)unit;
    return x * y;
}

static inline modular modular_square(modular_context *unit, modular x)
{
    (void)unit;
    return x * x;
}

/* Is a number of at most that magnitude, a multiple of 2^exponent, read off its last digits? */
static inline bool modular_is_whole(double magnitude, int exponent)
{
    return is_finite_bits(magnitude) && exponent_of(magnitude) + 2 <= exponent + 127;
}

/* The signed number x 2^exponent as nearly as a double-double can hold it. Entry: round to
 * nearest; the exponent is from -1022 to 800. */
static inline near modular_value(modular x, int exponent)
{
    bool negative = x >> 127 != 0;
    modular rest = negative ? -x : x;
    double hi = (double)rest;
    bool above = (modular)hi > rest;
    double lo = above ? -(double)((modular)hi - rest) : (double)(rest - (modular)hi);
    double unit = power_of_two(exponent), sign = negative ? -unit : unit;
    double error = fabs(lo) < 0x1p53 ? 0 : NEAR_ROUNDING * fabs(lo);
    return near_normal(sign * hi, sign * lo, unit * error);
}

#endif
#endif
