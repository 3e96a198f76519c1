/* SPDX-License-Identifier: MIT */
/* Cylinder: (A^2 W^2 - (A.W)^2) - A^2 r^2 <= 0, where 0 <= A.W <= A^2. */
#include "bisection_shape.h"

static void endless(const world *w, const vector *p, mpz_t out)
{
    mpz_t reach;
    mpz_init(reach);
    axis_distance(w, p, out);
    mpz_mul(reach, w->radius, w->radius);
    mpz_submul(out, reach, w->axis_square);
    mpz_clear(reach);
}

const bisection_row bisection_cylinder = {
    .fields = {{SURE_FIELD_BASE, ANCHOR, valid_point},
               {SURE_FIELD_TOP, OTHER_END, valid_end},
               {SURE_FIELD_RADIUS, RADIUS, valid_radius}},
    .body = endless,
    .body_part = SURE_PART_WALL,
    .planes = 2,
    .plane = end_planes,
    .plane_part = {SURE_PART_BASE, SURE_PART_TOP},
};
