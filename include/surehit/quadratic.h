/* SPDX-License-Identifier: MIT */
/* The quadratic by a quarter of its discriminant. */
#pragma once

#include <surehit/linkage.h>

SURE_C_BEGIN

typedef enum {
    SURE_ROOTS_NONE, /* no real root; roots untouched */
    SURE_ROOTS_ONE,  /* a = 0: the linear root in roots[0]; roots[1] untouched */
    SURE_ROOTS_TWO,  /* roots[0] <= roots[1]; a double root is written twice */
    SURE_ROOTS_ALL   /* a = b = c = 0: every t; roots untouched */
} sure_roots;

/* The real roots of a t^2 + 2 half_b t + c = 0, t = (-b/2 +- sqrt(D/4)) / a, D/4 = (b/2)^2 - a c.
 *
 * Entry    finite, of any sign. Where half_b^2 or a c overflows, but for stable, the count and the
 *          roots may be anything, NaNs too.
 * Returns  how many, as above.
 * Bound    SURE_ROOT_ULPS where both products and their difference D/4 are computed exactly; none
 *          elsewhere. Stable: the count is right, SURE_STABLE_ROOT_ULPS everywhere.
 * Source   notes, "ray - sphere intersection"; the printed -(b/2)^2 +- ... is an erratum.
 * Proof    docs/derivations/quadratic.md, docs/proofs/stable.md
 *
 * Law 1: on integers whose D/4 is computed exactly the count is right; where it is a square the
 *        roots are the correctly rounded quotients.
 * Law 2: (a, half_b, c) -> -(a, half_b, c) changes nothing; half_b -> -half_b mirrors the roots.
 * Law 3: multiplying all by 2^k (nothing over- or underflowing) changes nothing. */
SURE_TIERED(sure_roots, sure_quadratic, double a, double half_b, double c, double roots[2]);

SURE_C_END
