/* SPDX-License-Identifier: MIT */
#include "camera_laws.h"
#include "suite.h"

/* Every law, and so which matrix it is, of no view, of those along an axis (cases 1 to 6), across
 * one (7 and 8 among them), next to straight down, and of general vectors of any sizes, all three
 * coordinates as far apart as they come. */
LOOP_TEST(test_laws, PLAIN_TIERS)
{
    const int spread[] = {3, _i == SURE_TIER_FLOAT32 ? 120 : 1000, 0};
    const double small = _i == SURE_TIER_FLOAT32 ? 0x1p-149 : 0x1p-1074;
    const sure_vec3 odd[] = {{0, 0, 0},    {-0.0, 0, -0.0}, {NAN, 0, 1},    {0, INFINITY, 1},
                             {0, 0, -1},   {0, 0, 1},       {-1, 0, 0},     {1, 0, 0},
                             {0, -1, 0},   {0, 1, 0},       {small, -1, 0}, {0, 1, -small},
                             {small, 0, 0}};
    const uint64_t odds = sizeof odd / sizeof *odd;
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 v = {suite_double(11, i, spread[i % 3]), suite_double(12, i, spread[i / 3 % 3]),
                       suite_double(13, i, spread[i / 9 % 3])};
        if (i % 16 == 5 || i % 16 == 9)
            v.x = 0;
        if (i % 16 == 6)
            v.y = 0;
        if (i % 16 == 7)
            v.z = 0;
        if (i < odds)
            v = odd[i];
        const char *broken = rotation_law_broken((sure_tier)_i, v, suite_integer(14, i, 80));
        ck_assert_msg(!broken, "%s: (%a, %a, %a)", broken, v.x, v.y, v.z);
    }
}

SUITE("camera")
