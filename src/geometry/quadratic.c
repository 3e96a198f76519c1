/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "quadratic.h"

#include <assert.h>

sure_roots TIER(sure_quadratic)(double a_given, double half_b_given, double c_given,
                                double roots[2])
{
    assert(is_finite_bits(a_given) && is_finite_bits(half_b_given) && is_finite_bits(c_given));
    real a = (real)a_given, half_b = (real)half_b_given, c = (real)c_given;
    if (a == 0 && half_b == 0)
        return c == 0 ? SURE_ROOTS_ALL : SURE_ROOTS_NONE;
    if (a == 0) {
        roots[0] = -(c / half_b) / 2;
#ifdef SURE_STABLE
        if (fabs(roots[0]) > REAL_MAX) /* the root is half of that */
            roots[0] = -(c / 2 / half_b);
#endif
        return SURE_ROOTS_ONE;
    }
    real found[2];
    if (!quadratic_roots(a, half_b, c, found))
        return SURE_ROOTS_NONE;
    roots[0] = found[0];
    roots[1] = found[1];
    return SURE_ROOTS_TWO;
}
