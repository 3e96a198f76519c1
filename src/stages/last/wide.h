/* SPDX-License-Identifier: MIT */
/* Rounded numbers with the digits of long double and exponents without end, as exact ones have
 * them. For guesses: they decide nothing, they only tell where to look first. */
#pragma once

#include "../../numbers/exact.h"

#include <float.h>
#include <math.h>

/* digits * 2^exponent; the digits of a few products and quotients keep within their range. */
typedef struct {
    long double digits;
    int exponent;
} wide;

static inline wide wide_of(exact x)
{
    int exponent;
    if (x.sign == 0)
        return (wide){0, 0};
    long double top = (long double)exact_top(x, &exponent);
    return (wide){x.sign * top * 0x1p-64L, exponent + 64};
}

static inline wide wide_negate(wide x)
{
    return (wide){-x.digits, x.exponent};
}

/* Of which the digits are normal, and those of 0 have the least exponent. */
static inline wide wide_normal(wide x)
{
    int moved;
    if (x.digits == 0)
        return (wide){0, INT32_MIN / 4};
    long double digits = frexpl(x.digits, &moved);
    return (wide){digits, x.exponent + moved};
}

static inline wide wide_add(wide x, wide y)
{
    wide more = wide_normal(x), less = wide_normal(y);
    if (more.exponent < less.exponent) {
        wide moved = more;
        more = less;
        less = moved;
    }
    more.digits += ldexpl(less.digits, less.exponent - more.exponent);
    return more;
}

static inline wide wide_mul(wide x, wide y)
{
    return (wide){x.digits * y.digits, x.exponent + y.exponent};
}

/* y not 0. */
static inline wide wide_div(wide x, wide y)
{
    return (wide){x.digits / y.digits, x.exponent - y.exponent};
}

/* x not negative. */
static inline wide wide_sqrt(wide x)
{
    int odd = x.exponent & 1; /* also where the exponent is negative */
    return (wide){sqrtl(odd ? 2 * x.digits : x.digits), (x.exponent - odd) / 2};
}

/* |x| < |y| */
static inline bool wide_is_less(wide x, wide y)
{
    x = wide_normal(x);
    y = wide_normal(y);
    return x.exponent != y.exponent ? x.exponent < y.exponent : fabsl(x.digits) < fabsl(y.digits);
}

/* A finite double near x; 0 where x is no number, which no guess should be. */
static inline double wide_double(wide x)
{
    x = wide_normal(x);
    if (x.exponent > 1024)
        x.exponent = 1025;
    long double value = ldexpl(x.digits, x.exponent < -2000 ? -2000 : x.exponent);
    if (fabsl(value) <= (long double)DBL_MAX)
        return (double)value;
    return value > 0 ? DBL_MAX : value < 0 ? -DBL_MAX : 0;
}
