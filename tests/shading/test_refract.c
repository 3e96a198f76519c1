/* SPDX-License-Identifier: MIT */
#include "refraction_truth.h"
#include "suite.h"
#include "objects.h"
#include "tiers.h"

#include <signal.h>

typedef sure_status refraction(sure_vec3, sure_vec3, double, sure_vec3 *);
typedef double share(sure_vec3, sure_vec3, double);
static refraction *const refract[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_refract);
static share *const fresnel[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_refract_fresnel);

static const sure_vec3 up = {0, 1, 0}, untouched = {5, 6, 7};

static sure_vec3 drawn(uint64_t stream, uint64_t index)
{
    return suite_doubles(stream, index, 2);
}

/* A small world of integers: every direction of a cube, these normals, ratios in eighths. */
static const sure_vec3 normals[] = {{0, 1, 0}, {1, 0, -1}, {-2, 0, 0}, {1, 1, 0}, {0, 0, 4}};
enum { NORMALS = sizeof normals / sizeof *normals, SIDE = 9, EIGHTHS = 33 };
enum { WORLD = NORMALS * SIDE * SIDE * SIDE * EIGHTHS };

typedef struct {
    sure_vec3 d, n;
    int eighths;
    double square; /* 64 (|N||d| cos t)^2 */
    double root;   /* its root where that is whole, or else -1 */
} world_case;

static world_case world(int index)
{
    int side = SIDE / 2;
    world_case w = {.n = normals[index % NORMALS]};
    w.eighths = 1 + (index /= NORMALS) % EIGHTHS;
    index /= EIGHTHS;
    w.d = (sure_vec3){index % SIDE - side, index / SIDE % SIDE - side, index / SIDE / SIDE - side};
    sure_vec3 turn = cross(w.n, w.d);
    double cosine = dot(w.n, w.d);
    w.square = 64 * cosine * cosine + (64 - w.eighths * w.eighths) * dot(turn, turn);
    double root = w.square >= 0 ? floor(sqrt(w.square)) : -1;
    w.root = root * root == w.square ? root : -1;
    return w;
}

/* Entry: w.root is the root. */
static sure_vec3 world_direction(const world_case *w)
{
    sure_vec3 along = times(w->eighths, cross(cross(w->n, w->d), w->n));
    return times(1 / (8 * dot(w->n, w->n)), plus(along, times(-w->root, w->n)));
}

static void check_one(int tier, double value)
{
    double least =
        tier == SURE_TIER_STABLE ? 1 - SURE_FRESNEL_ULPS * (double)unit((sure_tier)tier) : 1;
    ck_assert_msg(value >= least && value <= 1, "%a for 1", value);
}

/* Laws 1 and 6 */
LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    int total = 0, critical = 0, known = 0;
    for (int i = 0; i < WORLD; i++) {
        world_case w = world(i);
        double ratio = w.eighths / 8.0;
        sure_vec3 t = untouched;
        if (dot(w.d, w.d) == 0)
            continue;
        sure_status status = refract[_i](w.d, w.n, ratio, &t);
        double reflected = fresnel[_i](w.d, w.n, ratio);
        ck_assert(reflected >= 0 && reflected <= 1);
        ck_assert_int_eq(status, w.square >= 0 ? SURE_HIT : SURE_MISS);
        if (w.square < 0) {
            ck_vector_same(t, untouched);
            ck_double_same(reflected, 1);
            total++;
        } else if (w.root >= 0 && (w.eighths != 8 || dot(w.n, w.d) <= 0)) {
            ck_vector_same(t, world_direction(&w));
            known++;
        }
        if (w.eighths != 8 && (w.square == 0 || dot(w.n, w.d) == 0)) {
            check_one(_i, reflected);
            critical += w.square == 0;
        }
    }
    ck_assert_int_gt(total, WORLD / 8);
    ck_assert_int_gt(known, WORLD / 32);
    ck_assert_int_gt(critical, 50);
}

/* Laws 4 and 8, for ratios whose inverse is a number. */
LOOP_TEST(test_law_4, PLAIN_TIERS)
{
    int checked = 0;
    for (int i = 0; i < WORLD; i++) {
        world_case w = world(i);
        bool invertible = (w.eighths & (w.eighths - 1)) == 0;
        if (!invertible || w.root < 0 || dot(w.d, w.d) == 0 || dot(w.n, w.d) > 0)
            continue;
        sure_vec3 there = untouched, back = untouched, other_side = times(-1, w.n);
        double ratio = w.eighths / 8.0;
        ck_assert_int_eq(refract[_i](w.d, w.n, ratio, &there), SURE_HIT);
        ck_assert_int_eq(refract[_i](times(-1, there), other_side, 1 / ratio, &back), SURE_HIT);
        ck_vector_same(back, times(-1, w.d));
        ck_double_same(fresnel[_i](times(-1, there), other_side, 1 / ratio),
                       fresnel[_i](w.d, w.n, ratio));
        checked++;
    }
    ck_assert_int_gt(checked, WORLD / 100);
}

static void check_scaled(int tier, uint64_t i, int of_d, int of_n)
{
    sure_vec3 d = drawn(1, i), n = drawn(4, i), t = untouched, far = untouched;
    double ratio = fabs(suite_double(7, i, 2)) + 0.25;
    sure_status status = refract[tier](d, n, ratio, &t);
    sure_vec3 long_d = times_two_to(d, of_d), long_n = times_two_to(n, of_n);
    ck_assert_int_eq(refract[tier](long_d, long_n, ratio, &far), status);
    ck_vector_same(far, status == SURE_HIT ? times_two_to(t, of_d) : untouched);
    ck_double_same(fresnel[tier](long_d, long_n, ratio), fresnel[tier](d, n, ratio));
}

/* Lengths up to 1e13 in float32, 1e144 in textbook and 1e270 in stable, and one over these. */
LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    static const int alone[PLAIN_TIERS] = {45, 480, 900}, both[PLAIN_TIERS] = {20, 235, 900};
    for (uint64_t i = 0; i < 1000; i++) {
        check_scaled(_i, i, alone[_i], 0);
        check_scaled(_i, i, -alone[_i], 0);
        check_scaled(_i, i, 0, alone[_i]);
        check_scaled(_i, i, 0, -alone[_i]);
        check_scaled(_i, i, both[_i], both[_i]);
        check_scaled(_i, i, -both[_i], -both[_i]);
        check_scaled(_i, i, -both[_i], both[_i]);
    }
}

/* Laws 3 and 6 */
LOOP_TEST(test_law_3, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 d = drawn(11, i), n = drawn(14, i), t = untouched;
        if (i % 2 == 0)
            n = i % 4 == 0 ? (sure_vec3){-d.y, d.x, 0} : times(-1, d);
        ck_assert_int_eq(refract[_i](d, n, 1, &t), SURE_HIT);
        ck_vector_same(t, rounded_vector((sure_tier)_i, d));
        ck_double_same(fresnel[_i](d, n, 1), 0);
        double ratio = 1 - ldexp(1, -1 - (int)(i % 23));
        ck_assert_int_eq(refract[_i](d, n, ratio, &t), SURE_HIT);
        ck_assert(fresnel[_i](d, n, ratio) > 0);
    }
}

/* Law 7 */
LOOP_TEST(test_law_7, PLAIN_TIERS)
{
    const sure_vec3 down = {0, -1, 0};
    ck_double_same(fresnel[_i](down, up, 3), 0.25);
    ck_double_same(fresnel[_i](down, up, 7), 0.5625);
    for (uint64_t i = 0; i < 1000; i++) {
        double ratio = suite_rounded(_i, fabs(suite_double(21, i, 3)) + 0.125);
        double amplitude =
            suite_rounded(_i, suite_rounded(_i, ratio - 1) / suite_rounded(_i, ratio + 1));
        double expected = suite_rounded(_i, amplitude * amplitude);
        double off = fabs(fresnel[_i](down, up, ratio) - expected);
        ck_assert(off <= (_i == SURE_TIER_STABLE
                              ? SURE_FRESNEL_ULPS * (double)unit((sure_tier)_i) * expected
                              : 0));
    }
    double across = suite_rounded(_i, 0.6); /* tan i = n2/n1: half of the across polarisation */
    double half = suite_rounded(_i, across * across) / 2;
    ck_double_same(fresnel[_i]((sure_vec3){2, -1, 0}, up, 0.5), half);
    ck_double_same(fresnel[_i]((sure_vec3){0, -2, 1}, up, 2), half);
}

/* Law 9: into glass up to grazing incidence, out of it up to total reflection and beyond. */
LOOP_TEST(test_law_9, PLAIN_TIERS)
{
    static const double ratios[] = {1 / 2.42, 1 / 1.5, 0.75, 1.33, 1.5, 2.42};
    for (size_t k = 0; k < sizeof ratios / sizeof *ratios; k++) {
        double before = 0;
        for (int i = 0; i <= 16; i++) {
            sure_vec3 d = {i, i - 16, 0};
            double now = fresnel[_i](d, up, ratios[k]);
            ck_assert_msg(now > before || (ratios[k] > 1 && before == 1 && now == 1),
                          "ratio %g, angle %d: %a after %a", ratios[k], i, now, before);
            before = now;
        }
        check_one(_i, before);
    }
}

/* Any angle and ratio, and by ever smaller powers of two: in the surface, along the normal, of
 * almost equal indices, and at the critical angle. */
static refraction_question draw(int tier, uint64_t i)
{
    double small = ldexp(suite_double(31, i, 0), -(int)(suite_bits(32, i) % 60));
    sure_vec3 d = drawn(33, i), n = drawn(36, i);
    double ratio = ldexp(1 + suite_double(39, i, 0), 1);
    if (i % 8 == 2)
        d = plus(d, times(-(1 - small) * dot(d, n) / dot(n, n), n));
    if (i % 8 == 3)
        d = plus(times(-1, n), times(small, d));
    if (i % 8 == 4)
        ratio = 1 + small;
    if (i % 8 >= 5) {
        sure_vec3 turn = cross(n, d);
        ratio = (1 + small) * sqrt(dot(d, d) * dot(n, n) / dot(turn, turn));
    }
    return (refraction_question){rounded_vector((sure_tier)tier, d),
                                 rounded_vector((sure_tier)tier, n), suite_rounded(tier, ratio)};
}

enum { DRAWN = 8000 };

/* Laws 5, 6 and 10, and the bounds. */
LOOP_TEST(test_truth, PLAIN_TIERS)
{
    refraction_counts count = {0};
    for (uint64_t i = 0; i < DRAWN; i++) {
        refraction_question q = draw(_i, i);
        const char *broken = refraction_broken((sure_tier)_i, &q, &count);
        if (broken)
            ck_abort_msg("tier %d, d %a %a %a, N %a %a %a, ratio %a: %s", _i, q.d.x, q.d.y, q.d.z,
                         q.n.x, q.n.y, q.n.z, q.ratio, broken);
    }
    ck_assert_uint_gt(count.refracted, DRAWN / 4);
    ck_assert_uint_gt(count.total, DRAWN / 8);
    ck_assert_int_eq(count.mistaken == 0, _i == SURE_TIER_STABLE);
}

/* Law 2 of components that are far less than D is long. */
TEST(test_small_components)
{
    const sure_vec3 d = {1, 0x1p-1000, -1};
    sure_vec3 plain, way;
    ck_assert_int_eq(sure_refract_stable(d, (sure_vec3){0, 0, 1}, 0.5, &plain), SURE_HIT);
    ck_assert(plain.y > 0);
    for (int k = -1000; k <= 1000; k += 50) {
        ck_assert_int_eq(sure_refract_stable(d, (sure_vec3){0, 0, ldexp(1, k)}, 0.5, &way),
                         SURE_HIT);
        ck_vector_same(way, plain);
    }
}

/* All squares are in range, but |d|/|N| is not. */
SIGNAL_TEST(test_overflow, SIGABRT)
{
    sure_vec3 unused;
    (void)sure_refract_textbook((sure_vec3){0x1p520, -0x1p520, 0}, (sure_vec3){0, 0x1p-510, 0}, 0.5,
                                &unused);
}

SIGNAL_TEST(test_underflow, SIGABRT)
{
    (void)sure_refract_fresnel_float32((sure_vec3){0x1p-100, -0x1p-100, 0},
                                       (sure_vec3){0, 0x1p60, 0}, 0.5);
}

SUITE("refract")
