/* What the terms of a formula come to: the same formula, of magnitudes that are added up where
 * numbers are subtracted. What doubles make of the formula is off by a share of it. */
#pragma once

#include "number.h"

#include <math.h>

typedef double most;
typedef no_context most_context;

#define MOST(operation, value, ...)                                                                \
    static inline most most_##operation(most_context *context, __VA_ARGS__)                        \
    {                                                                                              \
        (void)context;                                                                             \
        return value;                                                                              \
    }
MOST(of, fabs(x), double x)
MOST(difference_of, fabs(x - y), double x, double y)
MOST(negate, x, most x)
MOST(add, x + y, most x, most y)
MOST(mul, (x) * (y), most x, most y)
MOST(square, (x) * (x), most x)
#undef MOST

#define NUMBER most
#include "vector_tmpl.h"
