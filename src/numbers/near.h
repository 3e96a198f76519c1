/* A number known nearly: a double-double and a running bound of its error. Round to nearest is
 * required, gradual underflow is not: results and operands may be flushed. Every bound is derived
 * in docs/proofs/near.md.
 *
 * Where a value overflows, or by two_product without FMA a factor exceeds 2^995, the bound becomes
 * infinite or NaN, or hi + lo does, and no sign is certain from there on. */
#ifndef NUMBERS_NEAR_H
#define NUMBERS_NEAR_H

#include "bits.h"
#include "error_free.h"

/* |value - (hi + lo)| <= error, and |lo| <= 2^-53 |hi| + 2^-12 error. Either hi and lo are
 * multiples of 2^-1022, so that sums of them are never subnormal, or error >= NEAR_FLOOR. */
typedef struct {
    double hi, lo, error;
} near;

/* Set, never cleared, by an operation whose result is not known; what it returns is then no
 * number. */
typedef struct {
    bool uncertain;
} near_context;

/* Of this 2^-16 is more than all that can underflow in one operation. */
#define NEAR_FLOOR 0x1p-1000
/* From here on doubles are multiples of 2^-1022. */
#define NEAR_GRID 0x1p-970
/* Makes room for the roundings of the bound's own arithmetic, and for what is flushed. */
#define NEAR_SLACK (1 + 0x1p-10)
/* Bounds of one rounding, and of the roundings of one operation relative to hi. */
#define NEAR_ROUNDING 0x1p-53
#define NEAR_OF_PRODUCT 0x1.2p-103  /* 9 times 2^-106 */
#define NEAR_OF_SQUARE 0x1.cp-104   /* 7 */
#define NEAR_OF_QUOTIENT 0x1.4p-102 /* 20 */
#define NEAR_OF_ROOT 0x1.4p-104     /* 5 */

/* x + y as a near number, for what fast_two_sum takes. */
static inline near near_normal(double x, double y, double error)
{
    double_pair sum = fast_two_sum(x, y);
    return (near){sum.head, sum.tail, error};
}

static inline double near_floor_of(double x)
{
    return fabs(x) < NEAR_GRID && !is_zero_bits(x) ? NEAR_FLOOR : 0;
}

static inline bool near_is_zero(near x)
{
    return x.hi == 0 && x.error == 0;
}

static inline near near_of(near_context *context, double x)
{
    (void)context;
    return (near){x, 0, near_floor_of(x)};
}

static inline near near_sum_of(near_context *context, double x, double y)
{
    (void)context;
    double_pair sum = two_sum(x, y);
    return (near){sum.head, sum.tail, near_floor_of(x) + near_floor_of(y)};
}

static inline near near_difference_of(near_context *context, double x, double y)
{
    return near_sum_of(context, x, -y);
}

static inline near near_negate(near_context *context, near x)
{
    (void)context;
    return (near){-x.hi, -x.lo, x.error};
}

static inline near near_add(near_context *context, near x, near y)
{
    (void)context;
    double_pair s = two_sum(x.hi, y.hi);
    double v = x.lo + y.lo;
    double w = s.tail + v;
    double error = (x.error + y.error) + NEAR_ROUNDING * (fabs(v) + fabs(w));
    return near_normal(s.head, w, error * NEAR_SLACK);
}

static inline near near_sub(near_context *context, near x, near y)
{
    return near_add(context, x, near_negate(context, y));
}

static inline near near_mul(near_context *context, near x, near y)
{
    (void)context;
    double_pair p = two_product(x.hi, y.hi);
    double w = p.tail + (x.hi * y.lo + x.lo * y.hi);
    double error = x.error * (fabs(y.hi) + y.error) + y.error * fabs(x.hi);
    double floor = near_is_zero(x) || near_is_zero(y) ? 0 : NEAR_FLOOR;
    error = (error + (NEAR_OF_PRODUCT * fabs(p.head) + floor)) * NEAR_SLACK;
    return near_normal(p.head, w, error);
}

static inline near near_square(near_context *context, near x)
{
    (void)context;
    double_pair p = two_product(x.hi, x.hi);
    double w = p.tail + 2 * (x.hi * x.lo);
    double error = x.error * (2 * fabs(x.hi) + x.error);
    double floor = near_is_zero(x) ? 0 : NEAR_FLOOR;
    error = (error + (NEAR_OF_SQUARE * p.head + floor)) * NEAR_SLACK;
    return near_normal(p.head, w, error);
}

/* -1, 0 or +1. A zero is certain only where no error was made. */
static inline int near_sign(near_context *context, near x)
{
    double value = x.hi + x.lo;
    if (fabs(value) * (1 - 0x1p-10) > x.error)
        return value > 0 ? 1 : -1;
    if (!near_is_zero(x))
        context->uncertain = true;
    return 0;
}

/* Uncertain unless x is certainly not negative. */
static inline near near_sqrt(near_context *context, near x)
{
    if (near_is_zero(x))
        return x;
    near_context alone = {false};
    if (near_sign(&alone, x) <= 0) {
        context->uncertain = true;
        return (near){0, 0, 0};
    }
    double r = sqrt(x.hi);
    double_pair p = two_product(r, r);
    double residual = ((x.hi - p.head) - p.tail) + x.lo;
    double error = (x.error + NEAR_FLOOR) / r + NEAR_OF_ROOT * r;
    return near_normal(r, residual / (2 * r), error * NEAR_SLACK);
}

/* Uncertain unless y is certainly not zero. */
static inline near near_div(near_context *context, near x, near y)
{
    double least = fabs(y.hi) * (1 - 0x1p-10) - y.error;
    if (!(least > 0)) {
        context->uncertain = true;
        return (near){0, 0, 0};
    }
    if (near_is_zero(x))
        return x;
    double q = x.hi / y.hi;
    double_pair p = two_product(q, y.hi);
    double residual = ((x.hi - p.head) - p.tail) + (x.lo - q * y.lo);
    double error = (x.error + (fabs(q) + NEAR_FLOOR) * y.error + NEAR_FLOOR) / least;
    error = (error + (NEAR_OF_QUOTIENT * fabs(q) + NEAR_FLOOR)) * NEAR_SLACK;
    return near_normal(q, residual / y.hi, error);
}

#endif
