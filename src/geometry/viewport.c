/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "../numbers/real.h"

#include <surehit/viewport.h>

#include <assert.h>

/* tan(theta) = (extent / 2) / focal_length with theta = FOV / 2, in radians pi/360 FOV. Stable:
 * tan(theta) = 1 / tan(pi/2 - theta) beyond 45 degrees, where 180 - FOV is exact and a rounding of
 * theta would be magnified. */
double TIER(sure_viewport_extent)(double focal_length, double fov)
{
    assert(focal_length > 0 && is_finite_bits(focal_length) && 0 < fov && fov < 180);
    const real pi = (real)3.14159265358979323846;
#ifdef SURE_STABLE
    if (fov < 0x1p-500) /* tan is its argument, which may be subnormal */
        return focal_length * (pi / 180 * (fov * 0x1p500)) * 0x1p-500;
    if (fov <= 90)
        return focal_length * (2 * tan(pi / 360 * fov));
    return focal_length * (2 / tan(pi / 360 * (180 - fov)));
#else
    return 2 * (real)focal_length * REAL(tan)(pi / 360 * (real)fov);
#endif
}
