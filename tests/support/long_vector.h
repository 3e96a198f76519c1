/* SPDX-License-Identifier: MIT */
/* Vectors in long double, for tests in which it has 2^-11 of a double's roundings and a range that
 * squares of doubles don't leave. */
#pragma once

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include <surehit/vector.h>

#if LDBL_MANT_DIG < 64 || LDBL_MAX_EXP < 16384
#error "the tests need a long double of at least 64 digits and 15 bits of exponent"
#endif

/* More than the share that some ten roundings to 64 digits can change. */
#define LONG_SLACK 0x1p-50L

typedef struct {
    long double x, y, z;
} long_vector;

static inline long_vector long_of(sure_vec3 v)
{
    return (long_vector){v.x, v.y, v.z};
}

/* a v + b w */
static inline long_vector long_sum(long double a, long_vector v, long double b, long_vector w)
{
    return (long_vector){a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z};
}

static inline long_vector long_between(sure_vec3 from, sure_vec3 to)
{
    return long_sum(1, long_of(to), -1, long_of(from));
}

static inline long double long_dot(long_vector v, long_vector w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static inline long double long_length(long_vector v)
{
    return sqrtl(long_dot(v, v));
}

static inline long_vector long_unit(long_vector v)
{
    return long_sum(1 / long_length(v), v, 0, v);
}

/* Is it in 2^-most..2^most? */
static inline bool within_powers(long double x, int most)
{
    return x > ldexpl(1, -most) && x < ldexpl(1, most);
}
