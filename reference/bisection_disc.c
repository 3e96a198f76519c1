/* SPDX-License-Identifier: MIT */
/* Disc: W^2 - r^2 <= 0, where 0 <= A.W <= 0. */
#include "bisection_shape.h"

const bisection_row bisection_disc = {
    .fields = {{SURE_FIELD_CENTRE, ANCHOR, valid_point},
               {SURE_FIELD_NORMAL, NORMAL, valid_normal},
               {SURE_FIELD_RADIUS, RADIUS, valid_radius}},
    .body = ball,
    .body_part = SURE_PART_SURFACE,
    .planes = 2,
    .plane = flat_planes,
    .plane_part = {SURE_PART_SURFACE, SURE_PART_SURFACE},
};
