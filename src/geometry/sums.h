/* Sums and products of vectors, and of colours, in doubles. */
#pragma once

#include "../numbers/bits.h"

#include <surehit/vector.h>

static const double pi = 3.14159265358979323846;

static inline sure_vec3 add(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
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

static inline double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
