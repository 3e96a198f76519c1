/* SPDX-License-Identifier: MIT */
/* Exact numbers: sign * integer * 2^(EXACT_LIMB_BITS exponent), the integer in limbs on an arena
 * that the caller has on its stack. Sums, differences and products are exact whatever the inputs,
 * and doubles are read and written by their bits: no rounding mode and no flushing of subnormals
 * can change a result, and nothing is allocated.
 *
 *     exact_arena room;
 *     exact_context c = exact_start(&room);
 *     int side = exact_sign(&c, exact_sub(&c, exact_of(&c, x), exact_of(&c, y)));
 */
#pragma once

#include "bits.h"
#include "number.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* GMP's limbs where the build has found it, and else the widest of which the compiler has products
 * (digits/limbs_tmpl.h). */
#ifdef SURE_GMP
#include <gmp.h>
#if GMP_NAIL_BITS != 0
#error "surehit needs a GMP without nails"
#endif
typedef mp_limb_t exact_limb;
#define EXACT_LIMB_BITS GMP_NUMB_BITS
#elif defined __SIZEOF_INT128__
typedef uint64_t exact_limb;
#define EXACT_LIMB_BITS 64
#else
typedef uint32_t exact_limb;
#define EXACT_LIMB_BITS 32
#endif
_Static_assert(EXACT_LIMB_BITS == 64 || EXACT_LIMB_BITS == 32, "limbs hold a double's bits");

/* The arena's size. What is of degree k in the inputs is a multiple of 2^(-1074 k), and below
 * 2^(1025 k) in differences of two inputs, times as many such terms as it has: with less than 2^12
 * of them on no more than (2099 k + 12) / 64 + 2 limbs of 64 bits, the last 2 for its place among
 * them, which 35 k is not below, or on twice as many of 32. A product takes up the limbs of both
 * factors, a sum those that its terms span and one, before either is trimmed. */
#define EXACT_DEGREE_LIMBS (35 * 64 / EXACT_LIMB_BITS)
#define EXACT_LIMBS (65536 * 64 / EXACT_LIMB_BITS)

typedef struct {
    exact_limb limbs[EXACT_LIMBS];
} exact_arena;

/* `uncertain` stays false: it is for sources that are compiled over rounded numbers too. to_odd:
 * a number of an answer that is no double becomes the one of its neighbours whose last bit is 1.
 * Rounded once more, to floats, it is what the number itself would be. */
typedef struct {
    bool uncertain, to_odd;
    size_t used, capacity;
    exact_limb *limbs;
} exact_context;

/* The least and the most significant limb are not 0; zero has sign and size 0. The limbs are shared
 * and never written again. In 16 bytes it is passed and returned in registers, which halves the
 * time of short numbers. */
typedef struct {
    exact_limb *limbs;
    int32_t exponent;
    int16_t size, sign;
} exact;

/* The arena is not cleared: only what is used of it costs anything. */
static inline exact_context exact_start(exact_arena *room)
{
    return (exact_context){.capacity = EXACT_LIMBS, .limbs = room->limbs};
}

/* Forgets the numbers made since the mark. */
static inline size_t exact_mark(const exact_context *c)
{
    return c->used;
}

static inline void exact_release(exact_context *c, size_t mark)
{
    c->used = mark;
}

/* x must be finite; -0 is 0. */
exact exact_of(exact_context *c, double x);

/* mantissa * 2^exponent */
exact exact_scaled(exact_context *c, int64_t mantissa, int exponent);

exact exact_add(exact_context *c, exact x, exact y);
exact exact_mul(exact_context *c, exact x, exact y);

NUMBER_OPERATION(exact, square, exact_mul(context, x, x), exact x)
NUMBER_OPERATION(exact, difference_of,
                 exact_add(context, exact_of(context, x), exact_of(context, -y)), double x,
                 double y)
NUMBER_OPERATION(exact, negate, ((exact){x.limbs, x.exponent, x.size, (int16_t)-x.sign}), exact x)

/* -1, 0 or 1 */
static inline int exact_sign(exact_context *c, exact x)
{
    (void)c;
    return x.sign;
}

/* Sign of x - y. */
int exact_compare(exact_context *c, exact x, exact y);

/* The 64 leading bits of |x|, x not 0: bits * 2^*exponent <= |x| < (bits + 1) * 2^*exponent, and
 * the first of the bits is 1. */
uint64_t exact_top(exact x, int *exponent);

/* Do all numbers within off * 2^exponent of sign * digits * 2^exponent round to one double, by the
 * rules below? *rounded is what one of them rounds to. digits > 2^62, off < 2^32. */
bool exact_rounds(const exact_context *c, int sign, uint64_t digits, uint64_t off, int exponent,
                  double *rounded);

/* The double nearest to n/d, ties to even, by the rules of the default environment: subnormals are
 * kept, beyond the greatest double comes infinity; every zero is +0. Or to odd, where that is
 * asked. 0 for d = 0, which a line that misses has. */
double exact_quotient(exact_context *c, exact n, exact d);

#define NUMBER exact
#include "vector_tmpl.h"
