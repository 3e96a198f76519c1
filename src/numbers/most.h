/* SPDX-License-Identifier: MIT */
/* What the terms of a formula come to: the same formula, of magnitudes that are added up where
 * numbers are subtracted. What doubles make of the formula is off by a share of it. */
#pragma once

#include "number.h"

#include <math.h>

typedef double most;
typedef no_context most_context;

NUMBER_OPERATION(most, of, fabs(x), double x)
NUMBER_OPERATION(most, difference_of, fabs(x - y), double x, double y)
NUMBER_OPERATION(most, negate, x, most x)
NUMBER_OPERATION(most, add, x + y, most x, most y)
NUMBER_OPERATION(most, mul, (x) * (y), most x, most y)
NUMBER_OPERATION(most, square, (x) * (x), most x)

#define NUMBER most
#include "vector_tmpl.h"
