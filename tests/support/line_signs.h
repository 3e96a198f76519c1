/* SPDX-License-Identifier: MIT */
/* Exact facts about the line of a case, as signs of integers (GMP): what cases that claim to be
 * tangent, at a rim or on the boundary are checked against, from the definitions and without the
 * library. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "../../src/cases/case.h"

/* Signs are -1, 0, 1. The round body is the ball (of a disc the one around it), the infinite
 * cylinder or the double cone: a t^2 + 2 half_b t + c <= 0. A plane has none. */
typedef struct {
    int a, discriminant; /* half_b^2 - a c */
    int slope;           /* of d against the normal, or the way from the base to the other end */
    bool along_axis;     /* d is parallel to that */
    bool meets_base_rim, meets_end_rim, meets_apex;
} line_signs;

line_signs line_signs_of(const sure_case *valid);

/* The point at t = m 2^exponent. */
typedef struct {
    int round;            /* -1 in the round body, 0 on its boundary */
    int height, over_end; /* above the plane or base, above the plane of the other end */
} point_signs;

point_signs point_signs_at(const sure_case *valid, int64_t m, int exponent);
