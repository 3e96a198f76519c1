/* SPDX-License-Identifier: MIT */
/* The bits of doubles. Neither the rounding mode nor flushing of subnormals can change what these
 * functions say or return. */
#pragma once

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* What every decision rests on: IEEE arithmetic as written. A compiler that was told otherwise is
 * refused here. An FLT_EVAL_METHOD of 16 is about _Float16 alone. */
#if (FLT_EVAL_METHOD & ~16) != 0 || (defined(__i386__) && !defined(__SSE2_MATH__))
#error "surehit needs FLT_EVAL_METHOD 0: each operation rounded to its own type"
#endif
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024 || FLT_MANT_DIG != 24
#error "surehit needs IEEE 754 binary32 and binary64"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "surehit cannot be compiled with -ffast-math or a part of it"
#endif

/* What all rays pass through is computed where it is asked for, and what few reach is not, however
 * much the compiler has inlined already; what is rare takes little room, and whoever calls it saves
 * no registers for its sake. */
#ifdef __GNUC__
#define INLINED inline __attribute__((always_inline))
#define NOT_INLINED __attribute__((noinline))
#define RARE __attribute__((noinline, cold))
#else
#define INLINED inline
#define NOT_INLINED
#define RARE
#endif

/* x, of which the compiler knows nothing from here on: what it chooses is chosen by bits, where a
 * branch would be made of a condition. */
static INLINED uint64_t bits_unknown(uint64_t x)
{
#if defined(__GNUC__) && UINTPTR_MAX >= UINT64_MAX
    __asm__("" : "+r"(x));
#endif
    return x;
}

#define BITS_SIGN (UINT64_C(1) << 63)
#define BITS_FRACTION ((UINT64_C(1) << 52) - 1)
#define BITS_INFINITY (UINT64_C(0x7ff) << 52)

static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The bits of |x|. Among them the order of integers is that of magnitudes; NaNs come last. */
static inline uint64_t magnitude_bits(double x)
{
    return bits_of(x) & ~BITS_SIGN;
}

/* -0 is negative here. */
static inline bool is_negative_bits(double x)
{
    return bits_of(x) >> 63 != 0;
}

static inline bool is_zero_bits(double x)
{
    return magnitude_bits(x) == 0;
}

static inline bool is_finite_bits(double x)
{
    return magnitude_bits(x) < BITS_INFINITY;
}

/* e with 2^e <= |x| < 2^(e+1) for a normal x; -1023 for zero and subnormals, 1024 for the rest. */
static inline int exponent_of(double x)
{
    return (int)(magnitude_bits(x) >> 52) - 1023;
}

/* 2^e for -1022 <= e <= 1023. */
static inline double power_of_two(int e)
{
    return double_of((uint64_t)(e + 1023) << 52);
}

/* Of an integer up to its first 1; x is not 0. Without the second bit no rounding makes a greater
 * power of two of it. */
static inline int bits_in(uint64_t x)
{
#ifdef __GNUC__
    return 64 - __builtin_clzll(x);
#else
    return exponent_of((double)(x & ~(x >> 1))) + 1;
#endif
}

/* |x| = mantissa 2^exponent, exactly; the mantissa has at most 53 bits. */
typedef struct {
    uint64_t mantissa;
    int exponent;
} magnitude_parts;

/* x is finite. */
static inline magnitude_parts parts_of(double x)
{
    uint64_t bits = magnitude_bits(x), biased = bits >> 52, fraction = bits & BITS_FRACTION;
    if (biased == 0)
        return (magnitude_parts){fraction, -1074};
    return (magnitude_parts){fraction | (BITS_FRACTION + 1), (int)biased - 1075};
}
