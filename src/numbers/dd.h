/* SPDX-License-Identifier: MIT */
/* Numbers of twice the digits of double, without a bound of their own: a formula's bound is counted
 * for it as a whole. Round to nearest is required, gradual underflow is not.
 *
 * With |tail| <= 2^-53 |head| on entry, a sum, a product or a square is off by at most 16 2^-106 of
 * its terms; 32 where |tail| <= 3 2^-53 |head|, which products and squares leave, so that they need
 * no step more when they are added up (docs/proofs/dd.md). */
#pragma once

#include "error_free.h"
#include "number.h"

#include <assert.h>

typedef double_pair dd;

/* A bound that counts roundings of 2^-52 each, times this, is one for double-doubles:
 * 2^-101 each. */
#define DD_SHARE 0x1p-49

typedef no_context dd_context;

NUMBER_OPERATION(dd, of, ((dd){x, 0}), double x)
NUMBER_OPERATION(dd, difference_of, two_sum(x, -y), double x, double y) /* exactly */
NUMBER_OPERATION(dd, negate, ((dd){-x.head, -x.tail}), dd x)

/* Where heads cancel to less than the tails, they leave a multiple of the tails' last place: that
 * too is exact for fast_two_sum. */
static inline dd dd_add(dd_context *context, dd x, dd y)
{
    (void)context;
    dd sum = two_sum(x.head, y.head);
    return fast_two_sum(sum.head, sum.tail + (x.tail + y.tail));
}

/* x + y, not normalised: of a formula that counts for it. */
static inline dd dd_add_loosely(dd x, dd y)
{
    dd sum = two_sum(x.head, y.head);
    sum.tail += x.tail + y.tail;
    return sum;
}

static inline double dd_value(dd x)
{
    return x.head + x.tail;
}

static inline dd dd_mul(dd_context *context, dd x, dd y)
{
    (void)context;
    dd product = two_product(x.head, y.head);
    product.tail += x.head * y.tail + x.tail * y.head;
    return product;
}

static inline dd dd_square(dd_context *context, dd x)
{
    (void)context;
    dd square = two_product(x.head, x.head);
    square.tail += (2 * x.head + x.tail) * x.tail;
    return square;
}

/* Where y is 0 neither part is finite, and nothing is decided. */
static inline dd dd_div(dd_context *context, dd x, dd y)
{
    (void)context;
    double q = x.head / y.head;
    dd product = two_product(q, y.head);
    double rest = ((x.head - product.head) - product.tail) + (x.tail - q * y.tail);
    return two_sum(q, rest / y.head);
}

/* Entry: x's head is above zero. */
static inline dd dd_sqrt(dd_context *context, dd x)
{
    assert(x.head > 0);
    (void)context;
    double r = sqrt(x.head);
    dd square = two_product(r, r);
    double rest = ((x.head - square.head) - square.tail) + x.tail;
    return two_sum(r, rest / (2 * r));
}

#define NUMBER dd
#include "vector_tmpl.h"
