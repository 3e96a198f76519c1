/* The quadratic stem's formula, for the stems that solve one. */
#ifndef GEOMETRY_QUADRATIC_H
#define GEOMETRY_QUADRATIC_H

#include "../arithmetic/real.h"

#include <surehit/quadratic.h>

/* a t^2 + b t + c = 0, a != 0, with a quarter of the discriminant:
 *
 *     D/4 = (b/2)^2 - a c                        quarter
 *     t   = (-b/2 -+ sqrt(D/4)) / a              roots, ascending
 *
 * Two real roots for D/4 >= 0 (a double one twice), none otherwise; NaN counts as none. */
static inline int quadratic_roots(real a, real half_b, real c, real roots[2])
{
    real quarter = half_b * half_b - a * c;
    if (!(quarter >= 0))
        return 0;
    real root = REAL(sqrt)(quarter);
    real less = (-half_b - root) / a;
    real more = (-half_b + root) / a;
    roots[0] = a > 0 ? less : more;
    roots[1] = a > 0 ? more : less;
    return 1;
}

#endif
