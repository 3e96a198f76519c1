/* SPDX-License-Identifier: MIT */
/* Vectors and objects, as tests write them. */
#pragma once

#include "../../src/geometry/coordinate.h"

#include <surehit/object.h>

static inline sure_vec3 plus(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline sure_vec3 minus(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline sure_vec3 times(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

static inline double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline sure_vec3 cross(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline sure_vec3 vector_of(const double *x)
{
    return (sure_vec3){x[0], x[1], x[2]};
}

static inline void put_vector(double *x, sure_vec3 v)
{
    x[0] = v.x;
    x[1] = v.y;
    x[2] = v.z;
}

static inline sure_object sphere(double x, double y, double z, double radius)
{
    return (sure_object){SURE_SHAPE_SPHERE, {.sphere = {{x, y, z}, radius}}};
}
