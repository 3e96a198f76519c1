#include "../arithmetic/real.h"

#include <surehit/viewport.h>

/* tan(theta) = (extent / 2) / focal_length with theta = FOV / 2, in radians pi/360 FOV. */
double TIER(sure_viewport_extent)(double focal_length, double fov)
{
    const real pi = (real)3.14159265358979323846;
    return 2 * (real)focal_length * REAL(tan)(pi / 360 * (real)fov);
}
