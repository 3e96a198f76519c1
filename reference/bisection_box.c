/* SPDX-License-Identifier: MIT */
/* Box: no body, where 0 <= W_i <= A_i for each axis i. */
#include "bisection_shape.h"

/* Inside of its planes there is no other boundary. */
static void none(const world *w, const vector *p, mpz_t out)
{
    (void)w;
    (void)p;
    mpz_set_si(out, -1);
}

static void faces(const world *w, int index, plane *out)
{
    for (int i = 0; i < 3; i++)
        mpz_set_si(out->outward.x[i], i != index / 2 ? 0 : index % 2 == 0 ? -1 : 1);
    mpz_set(out->reach, w->axis.x[index / 2]);
    if (index % 2 == 0)
        mpz_set_ui(out->reach, 0);
}

/* Of no coordinate below that of the low corner. */
static bool valid_high(const double *v, const double *low)
{
    bool valid = valid_point(v, NULL);
    for (int i = 0; valid && i < 3; i++) {
        fraction x, y;
        fraction_init(&x);
        fraction_init(&y);
        fraction_set_double(&x, v[i]);
        fraction_set_double(&y, low[i]);
        valid = fraction_compare(&x, &y) >= 0;
        fraction_clear(&x);
        fraction_clear(&y);
    }
    return valid;
}

const bisection_row bisection_box = {
    .fields = {{SURE_FIELD_LOW, ANCHOR, valid_point}, {SURE_FIELD_HIGH, OTHER_END, valid_high}},
    .body = none,
    .body_part = SURE_PART_SURFACE,
    .planes = 6,
    .plane = faces,
    .plane_part = {SURE_PART_X_MIN, SURE_PART_X_MAX, SURE_PART_Y_MIN, SURE_PART_Y_MAX,
                   SURE_PART_Z_MIN, SURE_PART_Z_MAX},
};
