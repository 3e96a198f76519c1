/* SPDX-License-Identifier: MIT */
/* Three doubles: a point, a direction or a linear RGB colour. */
#pragma once

#include <surehit/linkage.h>

SURE_C_BEGIN

typedef struct {
    double x, y, z;
} sure_vec3;

/* The same in single precision. */
typedef struct {
    float x, y, z;
} sure_float_vec3;

/* Rows of a 3 by 3 matrix; it acts on column vectors. */
typedef struct {
    sure_vec3 row[3];
} sure_mat3;

SURE_C_END
