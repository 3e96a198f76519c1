/* SPDX-License-Identifier: MIT */
/* Integers modulo 2^128, times a power of two: of a polynomial of doubles the low bits, exactly. A
 * number that is known to be less than 2^127 of its units is known completely
 * (docs/proofs/mod128.md). */
#pragma once

#include "bits.h"
#include "number.h"

/* Integers modulo 2^128, the compiler's or of two words. They are shifted by 0 ... 127 places to
 * the left. */
#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 uint128;
#define UINT128(high, low) ((uint128)(high) << 64 | (low))
#define UINT128_HIGH(x) ((uint64_t)((x) >> 64))
#define UINT128_LOW(x) ((uint64_t)(x))
#define UINT128_OPERATION(operation, value, ...)                                                   \
    static inline uint128 uint128_##operation(__VA_ARGS__)                                         \
    {                                                                                              \
        return value;                                                                              \
    }
UINT128_OPERATION(add, x + y, uint128 x, uint128 y)
UINT128_OPERATION(mul, x *y, uint128 x, uint128 y)
UINT128_OPERATION(negate, -x, uint128 x)
UINT128_OPERATION(shifted, x << places, uint128 x, int places)
#else
typedef struct {
    uint64_t high, low;
} uint128;
#define UINT128(high, low) ((uint128){high, low})
#define UINT128_HIGH(x) ((x).high)
#define UINT128_LOW(x) ((x).low)

static inline uint128 uint128_add(uint128 x, uint128 y)
{
    uint64_t low = x.low + y.low;
    return (uint128){x.high + y.high + (low < x.low), low};
}

static inline uint128 uint128_negate(uint128 x)
{
    return (uint128){~x.high + (x.low == 0), -x.low};
}

static inline uint128 uint128_shifted(uint128 x, int places)
{
    if (places >= 64)
        return (uint128){x.low << (places - 64), 0};
    uint64_t passed = places == 0 ? 0 : x.low >> (64 - places);
    return (uint128){x.high << places | passed, x.low << places};
}

/* Of halves of the low words as on paper; of the high words what is below 2^128. */
static inline uint128 uint128_mul(uint128 x, uint128 y)
{
    uint64_t x0 = (uint32_t)x.low, x1 = x.low >> 32, y0 = (uint32_t)y.low, y1 = y.low >> 32;
    uint64_t least = x0 * y0, middle = x1 * y0 + (least >> 32), other = x0 * y1 + (uint32_t)middle;
    uint64_t high = x1 * y1 + (middle >> 32) + (other >> 32) + x.high * y.low + x.low * y.high;
    return (uint128){high, other << 32 | (uint32_t)least};
}
#endif

#define MOD128_BITS 128

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
    return places < MOD128_BITS ? uint128_shifted(x, places) : UINT128(0, 0);
}

/* Are the low bits 0? */
static inline bool mod128_is_zero(mod128 x)
{
    return (UINT128_HIGH(x.low) | UINT128_LOW(x.low)) == 0;
}

/* Read as a signed word. */
static inline bool mod128_is_negative(mod128 x)
{
    return UINT128_HIGH(x.low) >> 63 != 0;
}

/* low as it is when counted in units of 2^exponent, which is not above x.exponent. */
static inline uint128 mod128_align(mod128 x, int exponent)
{
    return mod128_shifted(x.low, x.exponent - exponent);
}

/* Where it is rarely asked, the long operations are called and not inlined: the code is shorter. */
#ifdef MOD128_APART
#define MOD128_LONG NUMBER_APART
#else
#define MOD128_LONG static inline
#endif

/* x is finite. */
MOD128_LONG mod128 mod128_of(mod128_context *context, double x)
{
    (void)context;
    magnitude_parts parts = parts_of(x);
    if (parts.mantissa == 0)
        return (mod128){UINT128(0, 0), MOD128_EXPONENT_OF_ZERO};
    int even = bits_in(parts.mantissa & -parts.mantissa) - 1;
    uint64_t odd = parts.mantissa >> even;
    uint64_t negative = -(uint64_t)is_negative_bits(x); /* signs are as good as random: no branch */
    return (mod128){UINT128(negative, (odd ^ negative) - negative), parts.exponent + even};
}

MOD128_LONG mod128 mod128_add(mod128_context *context, mod128 x, mod128 y)
{
    (void)context;
    int exponent = x.exponent < y.exponent ? x.exponent : y.exponent;
    return (mod128){uint128_add(mod128_align(x, exponent), mod128_align(y, exponent)), exponent};
}

NUMBER_OPERATION(mod128, negate, ((mod128){uint128_negate(x.low), x.exponent}), mod128 x)
NUMBER_OPERATION(mod128, difference_of,
                 mod128_add(context, mod128_of(context, x), mod128_of(context, -y)), double x,
                 double y)
NUMBER_OPERATION(mod128, mul, ((mod128){uint128_mul(x.low, y.low), x.exponent + y.exponent}),
                 mod128 x, mod128 y)
NUMBER_OPERATION(mod128, square, mod128_mul(context, x, x), mod128 x)

#define NUMBER mod128
#include "vector_tmpl.h"
