/* SPDX-License-Identifier: MIT */
/* The quadratic stem's formula, for the stems that solve one. */
#pragma once

#include "../numbers/real.h"
#ifdef SURE_STABLE
#include "../numbers/error_free.h"
#endif

#include <surehit/quadratic.h>

/* a t^2 + b t + c = 0, a != 0, with a quarter of the discriminant:
 *
 *     D/4 = (b/2)^2 - a c                        quarter
 *     t   = (-b/2 -+ sqrt(D/4)) / a              roots, ascending
 *
 * Two real roots for D/4 >= 0 (a double one twice), none otherwise; NaN counts as none.
 */
static inline int quadratic_ordered(real one, real other, real roots[2])
{
    roots[0] = one < other ? one : other;
    roots[1] = one < other ? other : one;
    return 1;
}

/* The roots without cancellation, given root = sqrt(D/4): the one whose two terms have one sign,
 * the other from the product c / a of both:
 *
 *     q = -(b/2 + sign(b/2) sqrt(D/4)),  t = q / a and c / q
 */
static inline void quadratic_pair(real a, real half_b, real c, real root, real roots[2])
{
    real q = half_b > 0 ? -half_b - root : root - half_b;
    real one = q / a;
    real other = half_b == 0 ? -one : root == 0 ? one : c / q;
    quadratic_ordered(one, other, roots);
}

#ifndef SURE_STABLE
typedef struct {
    real a, half_b, c;
} quadratic;

static inline real quadratic_quarter(const quadratic *q)
{
    return q->half_b * q->half_b - q->a * q->c;
}

/* Ascending for a > 0, descending for a < 0. Without roots, D/4 < 0, those of |D/4|, so that
 * whoever asks for the sign elsewhere need not wait for it. */
static inline void quadratic_ends(const quadratic *q, real quarter, real ends[2])
{
    real root = REAL(sqrt)(REAL(fabs)(quarter));
    ends[0] = (-q->half_b - root) / q->a;
    ends[1] = (-q->half_b + root) / q->a;
}

static inline int quadratic_roots(real a, real half_b, real c, real roots[2])
{
    const quadratic q = {a, half_b, c};
    real quarter = quadratic_quarter(&q), ends[2];
    if (!(quarter >= 0))
        return 0;
    quadratic_ends(&q, quarter, ends);
    roots[0] = a > 0 ? ends[0] : ends[1];
    roots[1] = a > 0 ? ends[1] : ends[0];
    return 1;
}
#else
/* Powers of two by which a, b/2 and c are near one, and t = 2^shift times the scaled one's: t -> t
 * 2^k brings the exponents of a and c together, one factor for all three brings them near 0. */
static inline int quadratic_scale(real *a, real *half_b, real *c)
{
    int of[3], shift = 0;
    (void)frexp(*a, &of[0]);
    (void)frexp(*half_b, &of[1]);
    (void)frexp(*c, &of[2]);
    if (*c != 0)
        shift = (of[2] - of[0]) / 2;
    else if (*half_b != 0)
        shift = of[1] - of[0];
    int of_a = of[0] + 2 * shift, of_b = of[1] + shift;
    int most = *half_b != 0 && of_b > of_a ? of_b : of_a;
    *a = ldexp(*a, 2 * shift - most);
    *half_b = ldexp(*half_b, shift - most);
    *c = ldexp(*c, -most);
    return shift;
}

static inline int quadratic_is_moderate(real x)
{
    return x == 0 || (fabs(x) >= 0x1p-200 && fabs(x) <= 0x1p200);
}

/* D/4 with the errors of its products put back: within 2 u of itself, so of the right sign, and
 * zero exactly when it is (Cornea, Harrison and Tang). */
static inline int quadratic_moderate_roots(real a, real half_b, real c, real roots[2])
{
    double_pair bb = two_product(half_b, half_b), ac = two_product(a, c);
    real quarter = (bb.head - ac.head) + (bb.tail - ac.tail);
    if (quarter < 0)
        return 0;
    quadratic_pair(a, half_b, c, sqrt(quarter), roots);
    return 1;
}

/* The same by powers of two. Where a c is nothing beside (b/2)^2 the roots are -b/a and -c/b. */
static inline int quadratic_scaled_roots(real a, real half_b, real c, real roots[2])
{
    real near_a = a, near_b = half_b, near_c = c, found[2];
    int shift = quadratic_scale(&near_a, &near_b, &near_c);
    if (fabs(near_a) < 0x1p-200)
        return quadratic_ordered(-2 * (half_b / a), -(c / half_b) / 2, roots);
    if (!quadratic_moderate_roots(near_a, near_b, near_c, found))
        return 0;
    return quadratic_ordered(ldexp(found[0], shift), ldexp(found[1], shift), roots);
}

static inline int quadratic_roots(real a, real half_b, real c, real roots[2])
{
    if (quadratic_is_moderate(a) && quadratic_is_moderate(half_b) && quadratic_is_moderate(c))
        return quadratic_moderate_roots(a, half_b, c, roots);
    return quadratic_scaled_roots(a, half_b, c, roots);
}
#endif
