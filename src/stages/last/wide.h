/* SPDX-License-Identifier: MIT */
/* Numbers of 64 bits, with a bound of what they are off by and exponents without end, as exact ones
 * have them. All is integers: no rounding mode and no flushing matters. docs/proofs/wide.md. */
#pragma once

#include "../../numbers/exact.h"

/* The number lies within off * 2^exponent of sign * digits * 2^exponent; the first of the digits is
 * 1, or all are 0 and the sign is. */
typedef struct {
    uint64_t digits, off;
    int exponent, sign;
} wide;

wide wide_of(exact x);
wide wide_add(wide x, wide y);
wide wide_mul(wide x, wide y);
wide wide_div(wide x, wide y);

/* x not negative. */
wide wide_sqrt(wide x);

static inline wide wide_negate(wide x)
{
    x.sign = -x.sign;
    return x;
}

/* |x| is some `bits` bits less than |y|, or more. */
static inline bool wide_is_less(wide x, wide y, int bits)
{
    return x.digits == 0 || (y.digits != 0 && x.exponent < y.exponent - bits);
}

/* The double that the number rounds to (exact.h), if only one is known; or else one near it. */
bool wide_rounds(const exact_context *c, wide x, double *rounded);
