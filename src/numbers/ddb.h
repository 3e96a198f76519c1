/* SPDX-License-Identifier: MIT */
/* A number known nearly: a double-double and a running bound of its error. Round to nearest is
 * required, gradual underflow is not: results and operands may be flushed. Every bound is derived
 * in docs/proofs/ddb.md.
 *
 * Where a value overflows, or by two_product without FMA a factor exceeds 2^995, the bound becomes
 * infinite or NaN, or hi + lo does, and no sign is certain from there on. */
#pragma once

#include "bits.h"
#include "error_free.h"
#include "number.h"

/* |value - (hi + lo)| <= error, and |lo| <= 2^-53 |hi| + 2^-12 error. Either hi and lo are
 * multiples of 2^-1022, so that sums of them are never subnormal, or error >= DDB_FLOOR. */
typedef struct {
    double hi, lo, error;
} ddb;

/* Set, never cleared, by an operation whose result is not known; what it returns is then no
 * number. */
typedef struct {
    bool uncertain;
} ddb_context;

/* Of this 2^-16 is more than all that can underflow in one operation. */
#define DDB_FLOOR 0x1p-1000
/* From here on doubles are multiples of 2^-1022. */
#define DDB_GRID 0x1p-970
/* Makes room for the roundings of the bound's own arithmetic, and for what is flushed. */
#define DDB_SLACK (1 + 0x1p-10)
/* Bounds of one rounding, and of the roundings of one operation relative to hi. */
#define DDB_ROUNDING 0x1p-53
#define DDB_OF_PRODUCT 0x1.2p-103  /* 9 times 2^-106 */
#define DDB_OF_SQUARE 0x1.cp-104   /* 7 */
#define DDB_OF_QUOTIENT 0x1.4p-102 /* 20 */
#define DDB_OF_ROOT 0x1.4p-104     /* 5 */

/* x + y as a near number, for what fast_two_sum takes. */
static inline ddb ddb_normal(double x, double y, double error)
{
    double_pair sum = fast_two_sum(x, y);
    return (ddb){sum.head, sum.tail, error};
}

static inline double ddb_floor_of(double x)
{
    return fabs(x) < DDB_GRID && !is_zero_bits(x) ? DDB_FLOOR : 0;
}

static inline bool ddb_is_zero(ddb x)
{
    return x.hi == 0 && x.error == 0;
}

NUMBER_OPERATION(ddb, of, ((ddb){x, 0, ddb_floor_of(x)}), double x)
NUMBER_OPERATION(ddb, negate, ((ddb){-x.hi, -x.lo, x.error}), ddb x)

static inline ddb ddb_sum_of(ddb_context *context, double x, double y)
{
    (void)context;
    double_pair sum = two_sum(x, y);
    return (ddb){sum.head, sum.tail, ddb_floor_of(x) + ddb_floor_of(y)};
}

NUMBER_OPERATION(ddb, difference_of, ddb_sum_of(context, x, -y), double x, double y)

/* x - y + a b, off by little of what it is itself, though x and a b be far greater. */
static inline ddb ddb_along(double x, double y, double a, double b)
{
    double_pair m = two_sum(x, -y), p = two_product(a, b), s = two_sum(m.head, p.head);
    double_pair r = two_sum(m.tail, p.tail), v = two_sum(s.tail, r.head);
    double_pair z = two_sum(s.head, v.head);
    double least = v.tail + r.tail, w = z.tail + least;
    double e = ddb_floor_of(a), f = ddb_floor_of(b);
    double of_product =
        is_zero_bits(a) || is_zero_bits(b) ? 0 : DDB_FLOOR + (e * (fabs(b) + f) + f * fabs(a));
    double of_operands = of_product + (ddb_floor_of(x) + ddb_floor_of(y));
    double error = (of_operands + DDB_ROUNDING * (fabs(least) + fabs(w))) * DDB_SLACK;
    z = two_sum(z.head, w);
    return (ddb){z.head, z.tail, error};
}

static inline ddb ddb_add(ddb_context *context, ddb x, ddb y)
{
    (void)context;
    double_pair s = two_sum(x.hi, y.hi);
    double v = x.lo + y.lo;
    double w = s.tail + v;
    double error = (x.error + y.error) + DDB_ROUNDING * (fabs(v) + fabs(w));
    return ddb_normal(s.head, w, error * DDB_SLACK);
}

static inline ddb ddb_mul(ddb_context *context, ddb x, ddb y)
{
    (void)context;
    double_pair p = two_product(x.hi, y.hi);
    double w = p.tail + (x.hi * y.lo + x.lo * y.hi);
    double error = x.error * (fabs(y.hi) + y.error) + y.error * fabs(x.hi);
    double floor = ddb_is_zero(x) || ddb_is_zero(y) ? 0 : DDB_FLOOR;
    error = (error + (DDB_OF_PRODUCT * fabs(p.head) + floor)) * DDB_SLACK;
    return ddb_normal(p.head, w, error);
}

static inline ddb ddb_square(ddb_context *context, ddb x)
{
    (void)context;
    double_pair p = two_product(x.hi, x.hi);
    double w = p.tail + 2 * (x.hi * x.lo);
    double error = x.error * (2 * fabs(x.hi) + x.error);
    double floor = ddb_is_zero(x) ? 0 : DDB_FLOOR;
    error = (error + (DDB_OF_SQUARE * p.head + floor)) * DDB_SLACK;
    return ddb_normal(p.head, w, error);
}

/* No less than the value's magnitude, in any rounding mode. */
static inline double ddb_most(ddb x)
{
    return (fabs(x.hi) + fabs(x.lo) + x.error) * (1 + 0x1p-40);
}

/* -1, 0 or +1. A zero is certain only where no error was made. */
static inline int ddb_sign(ddb_context *context, ddb x)
{
    double value = x.hi + x.lo;
    if (fabs(value) * (1 - 0x1p-10) > x.error)
        return value > 0 ? 1 : -1;
    if (!ddb_is_zero(x))
        context->uncertain = true;
    return 0;
}

/* Uncertain unless x is certainly not negative. */
static inline ddb ddb_sqrt(ddb_context *context, ddb x)
{
    if (ddb_is_zero(x))
        return x;
    ddb_context alone = {false};
    if (ddb_sign(&alone, x) <= 0) {
        context->uncertain = true;
        return (ddb){0, 0, 0};
    }
    double r = sqrt(x.hi);
    double_pair p = two_product(r, r);
    double residual = ((x.hi - p.head) - p.tail) + x.lo;
    double error = (x.error + DDB_FLOOR) / r + DDB_OF_ROOT * r;
    return ddb_normal(r, residual / (2 * r), error * DDB_SLACK);
}

/* Uncertain unless y is certainly not zero. */
static inline ddb ddb_div(ddb_context *context, ddb x, ddb y)
{
    double least = fabs(y.hi) * (1 - 0x1p-10) - y.error;
    if (!(least > 0)) {
        context->uncertain = true;
        return (ddb){0, 0, 0};
    }
    if (ddb_is_zero(x))
        return x;
    double q = x.hi / y.hi;
    double_pair p = two_product(q, y.hi);
    double residual = ((x.hi - p.head) - p.tail) + (x.lo - q * y.lo);
    double error = (x.error + (fabs(q) + DDB_FLOOR) * y.error + DDB_FLOOR) / least;
    error = (error + (DDB_OF_QUOTIENT * fabs(q) + DDB_FLOOR)) * DDB_SLACK;
    return ddb_normal(q, residual / y.hi, error);
}

/* The double nearest to a number known nearly, when its error leaves no other; not for numbers near
 * the ends of the range. */
static inline bool ddb_rounds_to(ddb x, double *rounded)
{
    double slack = x.error * (1 + 0x1p-40) + fabs(x.lo) * 0x1p-50;
    *rounded = x.hi;
    return fabs(x.hi) > 0x1p-900 && x.hi + (x.lo + slack) == x.hi && x.hi + (x.lo - slack) == x.hi;
}

#define NUMBER ddb
#include "vector_tmpl.h"

/* v / length */
static inline vector_ddb vector_over_ddb(ddb_context *c, vector_ddb v, ddb length)
{
    return (vector_ddb){ddb_div(c, v.x, length), ddb_div(c, v.y, length), ddb_div(c, v.z, length)};
}
