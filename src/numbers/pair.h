/* Numbers of twice the digits of double, without a bound of their own: a formula's bound is counted
 * for it as a whole. Round to nearest is required, gradual underflow is not.
 *
 * With |tail| <= 2^-53 |head| on entry, a sum, a product or a square is off by at most 16 2^-106 of
 * its terms; 32 where |tail| <= 3 2^-53 |head|, which products and squares leave, so that they need
 * no step more when they are added up (docs/proofs/pair.md). */
#ifndef NUMBERS_PAIR_H
#define NUMBERS_PAIR_H

#include "error_free.h"

typedef double_pair pair;

/* A bound that counts roundings of 2^-52 each, times this, is one for pairs: 2^-101 each. */
#define PAIR_SHARE 0x1p-49

/* One that the numbers of several stages have (intersect/number.h); pairs have no use for it. */
typedef struct {
    char unused;
} pair_context;

static inline pair pair_of(pair_context *context, double x)
{
    (void)context;
    return (pair){x, 0};
}

/* x - y, exactly. */
static inline pair pair_difference_of(pair_context *context, double x, double y)
{
    (void)context;
    return two_sum(x, -y);
}

static inline pair pair_negate(pair_context *context, pair x)
{
    (void)context;
    return (pair){-x.head, -x.tail};
}

/* Where heads cancel to less than the tails, they leave a multiple of the tails' last place: that
 * too is exact for fast_two_sum. */
static inline pair pair_add(pair_context *context, pair x, pair y)
{
    (void)context;
    pair sum = two_sum(x.head, y.head);
    return fast_two_sum(sum.head, sum.tail + (x.tail + y.tail));
}

static inline pair pair_sub(pair_context *context, pair x, pair y)
{
    return pair_add(context, x, pair_negate(context, y));
}

static inline pair pair_mul(pair_context *context, pair x, pair y)
{
    (void)context;
    pair product = two_product(x.head, y.head);
    product.tail += x.head * y.tail + x.tail * y.head;
    return product;
}

static inline pair pair_square(pair_context *context, pair x)
{
    (void)context;
    pair square = two_product(x.head, x.head);
    square.tail += (2 * x.head + x.tail) * x.tail;
    return square;
}

/* Entry: y's head is not zero. */
static inline pair pair_div(pair_context *context, pair x, pair y)
{
    (void)context;
    double q = x.head / y.head;
    pair product = two_product(q, y.head);
    double rest = ((x.head - product.head) - product.tail) + (x.tail - q * y.tail);
    return two_sum(q, rest / y.head);
}

/* Entry: x's head is above zero. */
static inline pair pair_sqrt(pair_context *context, pair x)
{
    (void)context;
    double r = sqrt(x.head);
    pair square = two_product(r, r);
    double rest = ((x.head - square.head) - square.tail) + x.tail;
    return two_sum(r, rest / (2 * r));
}

#endif
