/* SPDX-License-Identifier: MIT */
/* Vectors of reals, and the way between them and the public vectors of doubles. */
#pragma once

#include "real.h"

#include <surehit/vector.h>

#ifdef SURE_FLOAT32
typedef sure_float_vec3 vec3;
#else
typedef sure_vec3 vec3;
#endif

static inline vec3 vec3_from(sure_vec3 v)
{
    return (vec3){(real)v.x, (real)v.y, (real)v.z};
}

/* A vector of which only the direction counts: its power of two is taken out before it is narrowed.
 * */
static INLINED vec3 vec3_direction_from(sure_vec3 v)
{
    int exponent;
    (void)frexp(fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))), &exponent);
    return (vec3){(real)ldexp(v.x, -exponent), (real)ldexp(v.y, -exponent),
                  (real)ldexp(v.z, -exponent)};
}

static inline sure_vec3 vec3_public(vec3 v)
{
    return (sure_vec3){v.x, v.y, v.z};
}

static inline vec3 vec3_add(vec3 a, vec3 b)
{
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec3 vec3_sub(vec3 a, vec3 b)
{
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec3 vec3_between(sure_vec3 from, sure_vec3 to)
{
    return vec3_sub(vec3_from(to), vec3_from(from));
}

static inline vec3 vec3_scale(real k, vec3 v)
{
    return (vec3){k * v.x, k * v.y, k * v.z};
}

static inline vec3 vec3_negate(vec3 v)
{
    return (vec3){-v.x, -v.y, -v.z};
}

static inline real vec3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 vec3_cross(vec3 a, vec3 b)
{
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline int vec3_is_zero(vec3 v)
{
    return v.x == 0 && v.y == 0 && v.z == 0;
}

/* Neither zero nor overflowed nor NaN. */
static inline int vec3_is_direction(vec3 v)
{
    return !vec3_is_zero(v) && v.x - v.x == 0 && v.y - v.y == 0 && v.z - v.z == 0;
}

/* The largest component's power of two, taken out: |v| or its square would over- or underflow. */
static INLINED vec3 vec3_near_one(vec3 v)
{
    int exponent;
    real largest = REAL(fmax)(REAL(fabs)(v.x), REAL(fmax)(REAL(fabs)(v.y), REAL(fabs)(v.z)));
    (void)REAL(frexp)(largest, &exponent);
    return (vec3){REAL(ldexp)(v.x, -exponent), REAL(ldexp)(v.y, -exponent),
                  REAL(ldexp)(v.z, -exponent)};
}

/* v/|v|; zero for zero. Entry: finite. */
static INLINED vec3 vec3_unit(vec3 v)
{
    real square = vec3_dot(v, v);
    if (!(square > REAL_MIN_NORMAL / (REAL_EPSILON * REAL_EPSILON) && square < REAL_MAX)) {
        if (vec3_is_zero(v))
            return v;
        v = vec3_near_one(v);
        square = vec3_dot(v, v);
    }
    real length = REAL(sqrt)(square);
    return (vec3){v.x / length, v.y / length, v.z / length};
}
