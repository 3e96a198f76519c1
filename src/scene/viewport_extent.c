/* SPDX-License-Identifier: MIT */
#include "placement.h"

#include <mpfr.h>

double viewport_extent(double focal, double fov)
{
    mpfr_t tangent;
    mpfr_init2(tangent, 53);
    mpfr_set_d(tangent, fov, MPFR_RNDN);
    mpfr_tanu(tangent, tangent, 720, MPFR_RNDN); /* tan(2 pi fov / 720) */
    double extent = 2 * focal * mpfr_get_d(tangent, MPFR_RNDN);
    mpfr_clear(tangent);
    return extent;
}
