/* SPDX-License-Identifier: MIT */
/* Cone: A^2 (A^2 W^2 - (A.W)^2) - (r (A^2 - A.W))^2 <= 0, where 0 <= A.W <= A^2. Its radius at P's
 * height is r (A^2 - A.W) / A^2; between the planes only the kept nappe is left. The apex is a
 * wall. */
#include "bisection_shape.h"

static void endless(const world *w, const vector *p, mpz_t out)
{
    mpz_t reach;
    mpz_init(reach);
    axis_distance(w, p, out);
    mpz_mul(out, out, w->axis_square);
    height(w, p, reach);
    mpz_sub(reach, w->axis_square, reach);
    mpz_mul(reach, reach, w->radius);
    mpz_submul(out, reach, reach);
    mpz_clear(reach);
}

const bisection_row bisection_cone = {
    .fields = {{SURE_FIELD_BASE, ANCHOR, valid_point},
               {SURE_FIELD_APEX, OTHER_END, valid_end},
               {SURE_FIELD_RADIUS, RADIUS, valid_radius}},
    .body = endless,
    .body_part = SURE_PART_WALL,
    .planes = 2,
    .plane = end_planes,
    .plane_part = {SURE_PART_BASE, SURE_PART_WALL},
};
