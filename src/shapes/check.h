/* SPDX-License-Identifier: MIT */
#pragma once

#include "span.h"

/* Valid? For nearly every input at once, from numbers that a tier's formulas need anyway: true
 * only where sure_<shape>_check finds nothing, in any rounding mode, with subnormals taken for zero
 * or not. For what is not finite makes every sum, difference and product of it so, unless it is
 * divided by: infinity times 0 and infinity less infinity are NaNs. In single precision all of
 * this is no less so for the doubles that were rounded, in whose order floats are, if not equal. */
static inline bool range_surely_valid(const real_ray *ray)
{
    const real_bits infinity = real_bits_of((real)INFINITY);
    real_bits least = real_bits_of(ray->t_min), most = real_bits_of(ray->t_max);
    return least < most && most <= infinity;
}

static inline bool surely_finite(real x)
{
    return REAL(fabs)(x) < (real)INFINITY;
}

/* Neither zero nor NaN. */
static inline bool surely_not_zero(real x)
{
    return REAL(fabs)(x) > 0;
}

static inline bool radius_surely_valid(real radius)
{
    return real_bits_of(radius) < real_bits_of((real)INFINITY);
}

/* With N.rc and N.d, which is not 0 if N = 0 or d = 0. */
static inline bool flat_surely_valid(const real_ray *ray, real n_rc, real n_d)
{
    return surely_not_zero(n_d) && surely_finite(REAL(fabs)(n_rc) + REAL(fabs)(n_d)) &&
           range_surely_valid(ray);
}

/* With D/4 = (b/2)^2 - a c. Where it is finite, so are a and c; in these, d.d, |rc|^2 and r^2 are
 * terms, and beside them stands (N.rc)^2 / N.N or its like: a NaN for an axis that is not finite
 * or is 0. That d is not 0 the caller knows from another number. */
static inline bool round_surely_valid(const real_ray *ray, real discriminant, real radius)
{
    return surely_finite(discriminant) && radius_surely_valid(radius) && range_surely_valid(ray);
}
