/* A double as one of the numbers of number.h. */
#pragma once

#include "number.h"

typedef double f64;
typedef no_context f64_context;

#define F64(operation, value, ...)                                                                 \
    static inline f64 f64_##operation(f64_context *context, __VA_ARGS__)                           \
    {                                                                                              \
        (void)context;                                                                             \
        return value;                                                                              \
    }
F64(of, x, f64 x)
F64(difference_of, x - y, f64 x, f64 y)
F64(negate, -x, f64 x)
F64(add, x + y, f64 x, f64 y)
F64(sub, x - y, f64 x, f64 y)
F64(mul, (x) * (y), f64 x, f64 y)
F64(square, (x) * (x), f64 x)
#undef F64

#define NUMBER f64
#define NUMBER_HAS_SUB
#include "vector_tmpl.h"
#undef NUMBER_HAS_SUB
