/* Vectors in doubles, for what counts the rounding of each operation. */
#pragma once

#include <surehit/vector.h>

static inline sure_vec3 difference_of(sure_vec3 v, sure_vec3 w)
{
    return (sure_vec3){v.x - w.x, v.y - w.y, v.z - w.z};
}

/* v + k w */
static inline sure_vec3 sum_of(sure_vec3 v, double k, sure_vec3 w)
{
    return (sure_vec3){v.x + k * w.x, v.y + k * w.y, v.z + k * w.z};
}

static inline double dot_of(sure_vec3 v, sure_vec3 w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static inline sure_vec3 cross_of(sure_vec3 v, sure_vec3 w)
{
    return (sure_vec3){v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}
