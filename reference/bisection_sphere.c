/* SPDX-License-Identifier: MIT */
/* Sphere: W^2 - r^2 <= 0. */
#include "bisection_shape.h"

const bisection_row bisection_sphere = {
    .fields = {{SURE_FIELD_CENTRE, ANCHOR, valid_point}, {SURE_FIELD_RADIUS, RADIUS, valid_radius}},
    .body = ball,
    .body_part = SURE_PART_SURFACE,
};
