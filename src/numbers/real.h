/* SPDX-License-Identifier: MIT */
/* One source, three tiers: a stem's textbook is compiled with double as `textbook` and, with
 * SURE_FLOAT32, with float as `float32`; SURE_STABLE picks its stable form, in double, as `stable`,
 * of all but the shapes, whose stable is the first stage of certain. */
#pragma once

#include "bits.h"

#include <math.h>

#ifdef SURE_FLOAT32
typedef float real;
typedef uint32_t real_bits;
#define TIER(function) function##_float32
#define REAL(operation) operation##f
#define REAL_MIN_NORMAL FLT_MIN
#define REAL_MAX FLT_MAX
#define REAL_EPSILON FLT_EPSILON
#else
typedef double real;
typedef uint64_t real_bits;
#ifdef SURE_STABLE
#define TIER(function) function##_stable
#else
#define TIER(function) function##_textbook
#endif
#define REAL(operation) operation
#define REAL_MIN_NORMAL DBL_MIN
#define REAL_MAX DBL_MAX
#define REAL_EPSILON DBL_EPSILON
#endif

static inline real_bits real_bits_of(real x)
{
    real_bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline real real_of_bits(real_bits bits)
{
    real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}
