#include "shading_laws.h"
#include "suite.h"
#include "tiers.h"

#include <math.h>
#include <stdlib.h>

typedef double specular(sure_vec3, sure_vec3, sure_vec3, int);
typedef sure_vec3 mix(const sure_material *, sure_vec3, double, double);
typedef sure_vec3 mirror(const sure_material *, sure_vec3, sure_vec3);
static specular *const speculars[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_phong_specular);
static mix *const mixes[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_phong_mix);
static mirror *const mirrors[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_phong_mirror);

static const sure_vec3 up = {0, 1, 0};

LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    for (int shine = 0; shine < 200; shine += 33) {
        ck_double_same(speculars[_i](up, (sure_vec3){0, 7, 0}, (sure_vec3){0, 2, 0}, shine), 1);
        ck_double_same(speculars[_i](up, (sure_vec3){-8, 0, 0}, (sure_vec3){2, 0, 0}, shine), 1);
    }
    ck_double_same(speculars[_i](up, (sure_vec3){1, 1, 0}, (sure_vec3){1, 1, 0}, 3), 0);
}

LOOP_TEST(test_never_above_1, PLAIN_TIERS)
{
    for (int x = -9; x <= 9; x++) {
        sure_vec3 v = {x, 3, 5};
        double value = speculars[_i](v, v, v, 1000000000);
        ck_assert(value >= 0 && value <= 1);
    }
}

/* Eye straight above, light at cos 4/5: powers by plain multiplication. */
LOOP_TEST(test_power, PLAIN_TIERS)
{
    sure_vec3 light = {3, 4, 0};
    double c = suite_rounded(_i, 0.8), c2 = suite_rounded(_i, c * c);
    double c4 = suite_rounded(_i, c2 * c2), c5 = suite_rounded(_i, c * c4);
    ck_double_same(speculars[_i](up, up, light, 1), c);
    ck_double_same(speculars[_i](up, up, light, 2), c2);
    ck_double_same(speculars[_i](up, up, light, 4), c4);
    ck_double_same(speculars[_i](up, up, light, 5), c5);
}

LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    ck_double_same(speculars[_i](up, (sure_vec3){-3, 4, 0}, (sure_vec3){1, 1, 0}, 0), 1);
    ck_double_same(speculars[_i](up, up, (sure_vec3){1, -1, 0}, 0), 0);
    ck_double_same(speculars[_i](up, up, (sure_vec3){3, 4, 0}, 7),
                   speculars[_i](up, (sure_vec3){3, 4, 0}, up, 7));
}

LOOP_TEST(test_law_3, PLAIN_TIERS)
{
    sure_material m = {.color = {0.5, 0.25, 1}, .specular = 0.5};
    sure_vec3 light = {1, 2, 0.5};
    ck_vector_same(mixes[_i](&m, light, 1, 0), (sure_vec3){0.5, 0.5, 0.5});
    ck_vector_same(mixes[_i](&m, light, 0, 1), (sure_vec3){0.5, 1, 0.25});
    ck_vector_same(mixes[_i](&m, light, 0.5, 0.25), (sure_vec3){0.375, 0.5, 0.3125});
    ck_vector_same(mixes[_i](&m, (sure_vec3){0, 0, 0}, 1, 1), (sure_vec3){0, 0, 0});
    ck_vector_same(mixes[_i](&m, (sure_vec3){8, 16, 4}, 0.5, 0.25), (sure_vec3){3, 4, 2.5});
}

LOOP_TEST(test_mirror, PLAIN_TIERS)
{
    sure_material m = {.mirror = 0.25};
    sure_vec3 own = {1, 0.5, 0}, reflected = {0, 1, 2};
    ck_vector_same(mirrors[_i](&m, own, reflected), (sure_vec3){0.75, 0.625, 0.5});
    m.mirror = 0;
    ck_vector_same(mirrors[_i](&m, own, reflected), own);
    m.mirror = 1;
    ck_vector_same(mirrors[_i](&m, own, reflected), reflected);
}

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
        sure_vec3 twice =
            mixes[_i](&m, (sure_vec3){2 * in.x, 2 * in.y, 2 * in.z}, intensity, highlight);
        ck_vector_same(twice, (sure_vec3){2 * once.x, 2 * once.y, 2 * once.z});
    }
}

SUITE("phong")
