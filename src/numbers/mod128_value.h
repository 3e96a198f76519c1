/* From integers modulo 2^128 to double-doubles. */
#pragma once

#include "ddb.h"
#include "mod128.h"

/* x, which is whole, as nearly as a double-double can hold it. Entry: round to nearest; the
 * exponent is from -1022 to 800, or x is 0. */
static inline ddb mod128_value(mod128 x)
{
    if (x.low == 0)
        return (ddb){0, 0, 0};
    bool negative = x.low >> (MOD128_BITS - 1) != 0;
    uint128 rest = negative ? -x.low : x.low;
    double hi = (double)rest;
    bool above = (uint128)hi > rest;
    double lo = above ? -(double)((uint128)hi - rest) : (double)(rest - (uint128)hi);
    double unit = power_of_two(x.exponent), sign = negative ? -unit : unit;
    double error = fabs(lo) < 0x1p53 ? 0 : DDB_ROUNDING * fabs(lo);
    return ddb_normal(sign * hi, sign * lo, unit * error);
}
