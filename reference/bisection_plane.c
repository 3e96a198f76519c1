/* SPDX-License-Identifier: MIT */
/* Plane: 0 <= 0, where 0 <= A.W <= 0. */
#include "bisection_shape.h"

static void all_of_it(const world *w, const vector *p, mpz_t out)
{
    (void)w;
    (void)p;
    mpz_set_ui(out, 0);
}

const bisection_row bisection_plane = {
    .fields = {{SURE_FIELD_POINT, ANCHOR, valid_point}, {SURE_FIELD_NORMAL, NORMAL, valid_normal}},
    .body = all_of_it,
    .body_part = SURE_PART_SURFACE,
    .planes = 2,
    .plane = flat_planes,
    .plane_part = {SURE_PART_SURFACE, SURE_PART_SURFACE},
};
