/* SPDX-License-Identifier: MIT */
/* A vector's coordinates by number. C knows no array there: what lies an index behind &v.x is
 * undefined, and compilers make use of that. */
#pragma once

#include <surehit/vector.h>

static inline double coordinate(sure_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static inline double *coordinate_of(sure_vec3 *v, int axis)
{
    return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}
