/* Integers modulo 2^128, times a power of two: of a polynomial of doubles the low bits, exactly. A
 * number that is known to be less than 2^127 of its units is known completely
 * (docs/proofs/mod128.md). */
#pragma once

#include "bits.h"
#include "number.h"

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 uint128;
#define MOD128_ZEROS(x) __builtin_ctzll(x)
#else /* modulo 2^64: less is known completely */
typedef uint64_t uint128;
#define MOD128_ZEROS(x) exponent_of((double)(int64_t)((x) & -(x)))
#endif
#define MOD128_BITS (8 * (int)sizeof(uint128))

/* The value is I 2^exponent for an integer I that is low modulo 2^128. */
typedef struct {
    uint128 low;
    int exponent;
} mod128;

typedef no_context mod128_context;

/* Zero is a multiple of every power of two: larger than any exponent that arises, and such that a
 * product of a thousand zeros is in range. */
#define MOD128_EXPONENT_OF_ZERO (1 << 20)

static inline uint128 mod128_shifted(uint128 x, int places)
{
    return places < MOD128_BITS ? x << places : 0;
}

/* low as it is when counted in units of 2^exponent, which is not above x.exponent. */
static inline uint128 mod128_align(mod128 x, int exponent)
{
    return mod128_shifted(x.low, x.exponent - exponent);
}

/* x is finite. */
static inline mod128 mod128_of(mod128_context *context, double x)
{
    (void)context;
    magnitude_parts parts = parts_of(x);
    if (parts.mantissa == 0)
        return (mod128){0, MOD128_EXPONENT_OF_ZERO};
    int even = MOD128_ZEROS(parts.mantissa);
    uint128 odd = parts.mantissa >> even;
    uint128 negative = -(uint128)is_negative_bits(x); /* signs are as good as random: no branch */
    return (mod128){(odd ^ negative) - negative, parts.exponent + even};
}

static inline mod128 mod128_add(mod128_context *context, mod128 x, mod128 y)
{
    (void)context;
    int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    return (mod128){mod128_align(x, exponent) + mod128_align(y, exponent), exponent};
}

NUMBER_OPERATION(mod128, negate, ((mod128){-x.low, x.exponent}), mod128 x)
NUMBER_OPERATION(mod128, difference_of,
                 mod128_add(context, mod128_of(context, x), mod128_of(context, -y)), double x,
                 double y)
NUMBER_OPERATION(mod128, mul, ((mod128){x.low * y.low, x.exponent + y.exponent}), mod128 x,
                 mod128 y)
NUMBER_OPERATION(mod128, square, mod128_mul(context, x, x), mod128 x)

/* Is x, of at most that magnitude, read off its low bits: less than 2^127 units? */
static inline bool mod128_is_whole(double magnitude, mod128 x)
{
    return is_finite_bits(magnitude) && exponent_of(magnitude) + 2 <= x.exponent + MOD128_BITS - 1;
}

/* The sign of x, of at most that magnitude; false where it is not whole. */
static inline bool mod128_sign(double magnitude, mod128 x, int *sign)
{
    *sign = x.low >> (MOD128_BITS - 1) != 0 ? -1 : x.low != 0;
    return mod128_is_whole(magnitude, x);
}

#define NUMBER mod128
#include "vector_tmpl.h"
