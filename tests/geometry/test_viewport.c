/* SPDX-License-Identifier: MIT */
/* fuzz/fuzz_camera.c holds the extents against the reference, too. */
#include "placement.h"
#include "suite.h"

static double (*const extent[PLAIN_TIERS])(double, double) = OF_PLAIN_TIERS(sure_viewport_extent);

/* The formula, term by term in the tier's precision, and law 1. */
LOOP_TEST(test_formula, PLAIN_TIERS)
{
    for (int fov = 1; fov < 180; fov++) {
        const double pi = 3.14159265358979323846;
        double expected = 2 * tan(pi / 360 * fov);
        if (_i == SURE_TIER_FLOAT32)
            expected = 2 * tanf((float)pi / 360 * (float)fov);
        if (_i == SURE_TIER_STABLE && fov > 90)
            expected = 2 / tan(pi / 360 * (180 - fov));
        ck_double_same(extent[_i](1, fov), expected);
        ck_double_same(extent[_i](8, fov), 8 * expected);
    }
}

/* Near 180 degrees the tangent magnifies what rounding did to the angle, unless it is counted from
 * there; held against the tracer's, which is correctly rounded. */
TEST(test_wide)
{
    double textbook = 0, stable = 0;
    for (int k = 1; k < 1000; k++) {
        double fov = 180 - k / 1024.0, right = viewport_extent(1, fov);
        textbook = fmax(textbook, fabs(sure_viewport_extent_textbook(1, fov) / right - 1));
        stable = fmax(stable, fabs(sure_viewport_extent_stable(1, fov) / right - 1));
    }
    ck_assert_msg(1000 * stable < textbook, "%g, textbook %g", stable, textbook);
}

/* An angle that is subnormal loses no digits to what it is multiplied by: in radians it is the
 * extent. */
TEST(test_least_angles)
{
    const double degree = sure_viewport_extent_stable(1, 0x1p-400) * 0x1p400;
    for (int k = -1074; k < -500; k += 7)
        ck_double_same(sure_viewport_extent_stable(0x1p1000, ldexp(1, k)), ldexp(degree, 1000 + k));
}

SUITE("viewport")
