/* SPDX-License-Identifier: MIT */
/* A double as one of the numbers of number.h. */
#pragma once

#include "number.h"

typedef double f64;
typedef no_context f64_context;

NUMBER_OPERATION(f64, of, x, f64 x)
NUMBER_OPERATION(f64, difference_of, x - y, f64 x, f64 y)
NUMBER_OPERATION(f64, negate, -x, f64 x)
NUMBER_OPERATION(f64, add, x + y, f64 x, f64 y)
NUMBER_OPERATION(f64, sub, x - y, f64 x, f64 y)
NUMBER_OPERATION(f64, mul, (x) * (y), f64 x, f64 y)
NUMBER_OPERATION(f64, square, (x) * (x), f64 x)

#define NUMBER f64
#define NUMBER_HAS_SUB
#include "vector_tmpl.h"
#undef NUMBER_HAS_SUB
