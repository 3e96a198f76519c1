/* SPDX-License-Identifier: MIT */
#include "objects.h"
#include "shading_laws.h"
#include "suite.h"
#include "tiers.h"

typedef double specular(sure_vec3, sure_vec3, sure_vec3, int);
typedef sure_vec3 mix(const sure_material *, sure_vec3, double, double);
static specular *const speculars[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_phong_specular);
static mix *const mixes[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_phong_mix);

/* Laws 1 and 2 and the formula: any directions, the light near the mirrored eye, and across it. */
LOOP_TEST(test_highlights, PLAIN_TIERS)
{
    int bright = 0;
    for (uint64_t i = 0; i < 20000; i++) {
        int spread = i % 3 ? 1 : 30, shine = (int)(suite_bits(20, i) % (i % 7 ? 40 : 100000));
        sure_vec3 n = rounded_vector((sure_tier)_i, suite_doubles(11, i, spread));
        sure_vec3 v = rounded_vector((sure_tier)_i, suite_doubles(14, i, spread));
        sure_vec3 l = rounded_vector((sure_tier)_i, suite_doubles(17, i, spread));
        if (i % 2)
            l = rounded_vector((sure_tier)_i, sure_reflect_stable(v, n));
        if (i % 11 == 0)
            v = l = n;
        if (i % 4 == 3)
            l.x *= 1 + ldexp(1, -(int)(i % 20));
        const char *broken = highlight_broken((sure_tier)_i, n, v, l, shine);
        if (broken)
            ck_abort_msg("%s: case %d", broken, (int)i);
        bright += speculars[_i](n, v, l, shine) > 0.5;
    }
    ck_assert_int_gt(bright, 4000);
}

/* 0..1, in steps of 2^-7. */
static double share(uint64_t stream, uint64_t index)
{
    return abs(suite_integer(stream, index, 128)) / 128.0;
}

/* Law 3, and twice the light is twice as bright, to the bit. */
LOOP_TEST(test_mixes, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 color = {share(1, i), share(2, i), 1};
        sure_material m = {.color = color, .specular = share(3, i), .mirror = share(4, i)};
        sure_vec3 in = {fabs(suite_single(5, i, 9)), fabs(suite_single(6, i, 9)), 0.5};
        sure_vec3 from = {fabs(suite_single(7, i, 9)), 0, fabs(suite_single(8, i, 9))};
        double intensity = share(9, i), highlight = share(10, i);
        const char *broken = mix_broken((sure_tier)_i, &m, in, from, intensity, highlight);
        if (broken)
            ck_abort_msg("%s: case %d", broken, (int)i);
        sure_vec3 once = mixes[_i](&m, in, intensity, highlight);
        ck_vector_same(mixes[_i](&m, times(2, in), intensity, highlight), times(2, once));
    }
}

SUITE("phong")
