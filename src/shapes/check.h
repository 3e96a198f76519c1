#ifndef SHAPES_CHECK_H
#define SHAPES_CHECK_H

#include "../numbers/bits.h"
#include "../numbers/vec3.h"

#include <surehit/ray.h>

#include <math.h>
#include <stdbool.h>

/* Valid? For nearly every input at once, from numbers that a tier's formulas need anyway: true
 * only where sure_<shape>_check finds nothing, in any rounding mode, with subnormals taken for zero
 * or not. For what is not finite makes every sum, difference and product of it so, unless it is
 * divided by: infinity times 0 and infinity less infinity are NaNs. In single precision all of
 * this is no less so for the doubles that were rounded. */
static inline bool range_surely_valid(const sure_ray *ray)
{
    uint64_t least = bits_of(ray->t_min), most = bits_of(ray->t_max);
    return least < BITS_INFINITY && least <= most && most <= BITS_INFINITY;
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

static inline bool radius_surely_valid(double radius)
{
    return bits_of(radius) < BITS_INFINITY;
}

/* With N.rc and N.d, which is not 0 if N = 0 or d = 0. */
static inline bool flat_surely_valid(const sure_ray *ray, real n_rc, real n_d)
{
    return surely_not_zero(n_d) && surely_finite(REAL(fabs)(n_rc) + REAL(fabs)(n_d)) &&
           range_surely_valid(ray);
}

/* With D/4 = (b/2)^2 - a c. Where it is finite, so are a and c; in these, d.d, |rc|^2 and r^2 are
 * terms, and beside them stands (N.rc)^2 / N.N or its like: a NaN for an axis that is not finite
 * or is 0. That d is not 0 the caller knows from another number. */
static inline bool round_surely_valid(const sure_ray *ray, real discriminant, double radius)
{
    return surely_finite(discriminant) && radius_surely_valid(radius) && range_surely_valid(ray);
}

#endif
