/* SPDX-License-Identifier: MIT */
/* viewport_extent without MPFR: long double has 113 bits here. */
#include "../scene/placement.h"

#include <math.h>

/* Up to 45 degrees tan magnifies no error by more than pi/2, beyond them it is taken of the rest,
 * and the sum of roundings is below 2^-110: it rounds as the real tangent does unless that is so
 * near to the middle of two doubles, as by chance one of 2^56 is. */
double viewport_extent(double focal, double fov)
{
    const long double degree = 0x1.921fb54442d18469898cc51701b8p+1L / 360;
    bool is_small = fov <= 90;
    long double tangent = tanl(degree * (is_small ? fov : 180 - fov));
    return 2 * focal * (double)(is_small ? tangent : 1 / tangent);
}
