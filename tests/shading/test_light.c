/* SPDX-License-Identifier: MIT */
#include "objects.h"
#include "shading_laws.h"
#include "suite.h"
#include "tiers.h"

#include <signal.h>

typedef sure_vec3 color(const sure_light *, sure_vec3, sure_falloff);
static color *const colors[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_light_color);

static const sure_vec3 origin = {0, 0, 0};

/* A distance whose square is beyond double's range, above and below. */
LOOP_TEST(test_stable, PLAIN_TIERS)
{
    for (int k = -600; k <= 600; k += 1200) {
        sure_light light = {{0, ldexp(1, k), 0}, {1, 1, 1}, ldexp(1, k)};
        sure_vec3 seen = colors[_i](&light, origin, SURE_FALLOFF_INVERSE_SQUARE);
        double right = ldexp(1 / (4 * 3.14159265358979323846), -k);
        ck_assert_int_eq(seen.x == right, _i == SURE_TIER_STABLE);
    }
}

/* The way to the light is beyond the range itself. */
TEST(test_way_beyond_the_range)
{
    const sure_light light = {{0x1p1023, 0, 0}, {0x1p1000, 0, 0}, 0x1p1023};
    const sure_vec3 point = {-0x1p1023, 0, 0};
    sure_vec3 seen = sure_light_color_stable(&light, point, SURE_FALLOFF_INVERSE_SQUARE);
    ck_assert(seen.x == ldexp(1 / (4 * 3.14159265358979323846), -25));
}

/* A share beyond the range: no colour is lost, and what is dark stays dark. */
LOOP_TEST(test_overflow, PLAIN_TIERS)
{
    const sure_vec3 red = {1, 0, 0};
    sure_light light = {{0, 0x1p-60, 0}, red, _i == SURE_TIER_FLOAT32 ? 0x1p120 : 0x1p1000};
    for (int falloff = 0; falloff < 2; falloff++) {
        sure_vec3 seen = colors[_i](&light, origin, (sure_falloff)falloff);
        ck_assert(seen.x > 0 && seen.y == 0 && seen.z == 0);
        light.brightness = DBL_MAX;
    }
}

/* All laws and the formulas themselves, over sizes of all kinds: a light that is far, near, grazes,
 * is straight above or behind. */
LOOP_TEST(test_everywhere, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 20000; i++) {
        int spread = i % 3 ? 2 : 40;
        sure_vec3 point = rounded_vector((sure_tier)_i, suite_doubles(11, i, spread));
        sure_vec3 normal = rounded_vector((sure_tier)_i, suite_doubles(14, i, spread));
        sure_vec3 rgb = {fabs(suite_double(20, i, 0)), 1, 0.25};
        sure_light light = {rounded_vector((sure_tier)_i, suite_doubles(17, i, spread)),
                            rounded_vector((sure_tier)_i, rgb),
                            suite_rounded(_i, fabs(suite_double(21, i, spread)))};
        if (i % 5 == 0) /* across the normal, nearly; along it; at the point itself */
            light.position = (sure_vec3){point.x - normal.y, point.y + normal.x, point.z};
        if (i % 7 == 0)
            light.position = plus(point, times(i % 2 ? 4 : -4, normal));
        if (i % 29 == 0)
            light.position = point;
        light.position = rounded_vector((sure_tier)_i, light.position);
        const char *broken =
            light_broken((sure_tier)_i, point, normal, &light, (sure_falloff)(i % 2));
        if (broken)
            ck_abort_msg("%s: case %d", broken, (int)i);
    }
}

SIGNAL_TEST(test_brightness_below_0, SIGABRT)
{
    const sure_light light = {{0, 1, 0}, {1, 1, 1}, -1};
    (void)sure_light_color_textbook(&light, origin, SURE_FALLOFF_NONE);
}

SIGNAL_TEST(test_color_below_0, SIGABRT)
{
    const sure_light light = {{0, 1, 0}, {1, -1, 1}, 1};
    (void)sure_light_color_stable(&light, origin, SURE_FALLOFF_NONE);
}

SUITE("light")
