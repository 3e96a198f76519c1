/* Guesses: a double with an exponent of its own, so that no exact number is too large. What is
 * guessed decides nothing; it only tells where to look first. */
#pragma once

#include "exact.h"
#include "bits.h"

/* m 2^e with 1/2 <= |m| <= 1, or m = 0 */
typedef struct {
    double m;
    long e;
} wide;

static inline wide wide_normal(double m, long e)
{
    if (is_zero_bits(m))
        return (wide){0, 0};
    int shift = exponent_of(m) + 1;
    return (wide){m * power_of_two(-shift), e + shift};
}

static inline wide wide_of(exact x)
{
    if (x.sign == 0)
        return (wide){0, 0};
    int exponent;
    bool more;
    double m = (double)(exact_top(x, &exponent, &more) >> 11);
    return wide_normal(x.sign * m, exponent + 11);
}

static inline wide wide_mul(wide x, wide y)
{
    return wide_normal(x.m * y.m, x.e + y.e);
}

/* Entry: y is not zero. */
static inline wide wide_div(wide x, wide y)
{
    return wide_normal(x.m / y.m, x.e - y.e);
}

static inline wide wide_add(wide x, wide y)
{
    if (x.m == 0)
        return y;
    if (y.m == 0)
        return x;
    if (x.e < y.e)
        return wide_add(y, x);
    long apart = x.e - y.e;
    return apart > 100 ? x : wide_normal(x.m + y.m * power_of_two((int)-apart), x.e);
}

static inline wide wide_negate(wide x)
{
    return (wide){-x.m, x.e};
}

/* Entry: x is not negative. */
static inline wide wide_sqrt(wide x)
{
    bool odd = x.e % 2 != 0;
    return wide_normal(sqrt(odd ? x.m / 2 : x.m), odd ? (x.e + 1) / 2 : x.e / 2);
}

/* A double near x, within the doubles' range. */
static inline double wide_double(wide x)
{
    if (x.e > 1023)
        return x.m > 0 ? DBL_MAX : -DBL_MAX;
    if (x.e < -1021)
        return 0;
    return x.m * power_of_two((int)x.e);
}
