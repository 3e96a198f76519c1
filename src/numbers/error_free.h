/* SPDX-License-Identifier: MIT */
/* Sums and products of doubles without their rounding errors: x op y = head + tail. Round to
 * nearest is required. Exact but for overflow and where a tail would be subnormal. */
#pragma once

#include "bits.h"

#include <math.h>

/* Where a function returns it as an approximation, |tail| <= 2^-53 |head| need not hold. */
typedef struct {
    double head, tail;
} double_pair;

/* Knuth's: for any x, y. */
static inline double_pair two_sum(double x, double y)
{
    double head = x + y, of_y = head - x;
    return (double_pair){head, (x - (head - of_y)) + (y - of_y)};
}

/* Dekker's: for |x| >= |y|, or x a multiple of y's last place. */
static inline double_pair fast_two_sum(double x, double y)
{
    double head = x + y;
    return (double_pair){head, y - (head - x)};
}

#if defined PRODUCTS_APART && !defined __FP_FAST_FMA
#define EXACT_PRODUCT __attribute__((unused)) static NOT_INLINED double_pair
#else
#define EXACT_PRODUCT static INLINED double_pair
#endif

/* By an FMA where there is one, else by Dekker's and Veltkamp's splitting, the same number unless
 * that overflows or digits of a tail are below the least double. */
EXACT_PRODUCT two_product(double x, double y)
{
    double head = x * y;
#ifdef __FP_FAST_FMA
    return (double_pair){head, fma(x, y, -head)};
#else
    double x_up = 0x1.0000002p27 * x, y_up = 0x1.0000002p27 * y;
    double x1 = x_up - (x_up - x), y1 = y_up - (y_up - y), x2 = x - x1, y2 = y - y1;
    return (double_pair){head, ((x1 * y1 - head) + x1 * y2 + x2 * y1) + x2 * y2};
#endif
}
