/* SPDX-License-Identifier: MIT */
/* Sums and products of vectors, and of colours, in doubles. */
#pragma once

#include "../numbers/bits.h"

#include <surehit/vector.h>

static const double pi = 3.14159265358979323846;

static inline sure_vec3 add(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline sure_vec3 difference_of(sure_vec3 v, sure_vec3 w)
{
    return (sure_vec3){v.x - w.x, v.y - w.y, v.z - w.z};
}

/* v + k w */
static inline sure_vec3 sum_of(sure_vec3 v, double k, sure_vec3 w)
{
    return (sure_vec3){v.x + k * w.x, v.y + k * w.y, v.z + k * w.z};
}

static inline sure_vec3 negate(sure_vec3 v)
{
    return (sure_vec3){-v.x, -v.y, -v.z};
}

static inline sure_vec3 scaled(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

/* Channel by channel. */
static inline sure_vec3 product(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

static inline sure_vec3 cross_of(sure_vec3 v, sure_vec3 w)
{
    return (sure_vec3){v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

static inline double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
