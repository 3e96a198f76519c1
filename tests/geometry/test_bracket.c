/* SPDX-License-Identifier: MIT */
#include "suite.h"

#include "../support/surroundings.h"

#include <math.h>
#include <string.h>

typedef sure_status bracket(sure_implicit *, const void *, const sure_ray *, int, double *);
static bracket *const brackets[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_bracket);

/* |P|^2 - r^2, the unit-less sphere at the origin. */
static double sphere(const void *radius, sure_vec3 p)
{
    double r = *(const double *)radius;
    return p.x * p.x + p.y * p.y + p.z * p.z - r * r;
}

static double next(int tier, double t)
{
    return tier == SURE_TIER_FLOAT32 ? nextafterf((float)t, INFINITY) : nextafter(t, INFINITY);
}

/* The sign changes in the last step and in an only one. Where f is zero at P_n+1 itself the strict
 * change of the notes would pass it by. A ray that starts at or inside the surface has none (law
 * 2). A crossing and its return within one step are unseen. What is no hit is not written. */
LOOP_TEST(test_steps, PLAIN_TIERS)
{
    static const struct {
        sure_ray ray;
        int steps;
        sure_status status;
    } rows[] = {{{{-4, 0, 0}, {1, 0, 0}, 0, 8}, 16, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 4}, 1, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 4}, 2, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 4}, 3, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 4}, 4, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 8}, 8, SURE_HIT},
                {{{0, 0, 0}, {1, 0, 0}, 0, 8}, 8, SURE_MISS},
                {{{-1, 0, 0}, {-1, 0, 0}, 0, 8}, 8, SURE_MISS},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 8}, 1, SURE_MISS},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 8}, 2, SURE_HIT},
                {{{-4, 0, 0}, {1, 0, 0}, 0, INFINITY}, 8, SURE_INVALID},
                {{{-4, 0, 0}, {0, 0, 0}, 0, 8}, 8, SURE_INVALID},
                {{{-4, 0, 0}, {1, 0, 0}, 0, 8}, 0, SURE_INVALID}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double radius = 1, t[2] = {7, 7};
        ck_assert_int_eq(brackets[_i](sphere, &radius, &rows[i].ray, rows[i].steps, t),
                         rows[i].status);
        ck_double_same(t[1], rows[i].status == SURE_HIT ? 3 : 7);
        ck_double_same(rows[i].status == SURE_HIT ? next(_i, t[0]) : t[0], t[1]);
    }
}

/* Touched, and touched first at a step. */
LOOP_TEST(test_tangent, PLAIN_TIERS)
{
    double radius = 1, t[2];
    const sure_ray tangent = {{-4, 1, 0}, {1, 0, 0}, 0, 8};
    ck_assert_int_eq(brackets[_i](sphere, &radius, &tangent, 8, t), SURE_HIT);
    ck_assert(t[0] > 3 && t[1] <= 4);
}

LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    int found = 0;
    for (uint64_t i = 0; i < 500; i++) {
        double radius = 1 + (float)fabs(suite_double(1, i, 0)), t[2];
        sure_ray ray = {{-4, suite_single(2, i, 0), 0}, {1, 0, suite_single(3, i, 0)}, 0, 8};
        if (brackets[_i](sphere, &radius, &ray, 64, t) != SURE_HIT)
            continue;
        found++;
        ck_double_same(next(_i, t[0]), t[1]);
        for (int end = 0; end < 2; end++) {
            sure_vec3 p = {ray.origin.x + t[end] * ray.direction.x, ray.origin.y,
                           t[end] * ray.direction.z};
            if (_i == SURE_TIER_FLOAT32)
                p = (sure_vec3){(float)((float)ray.origin.x + (float)t[end]), p.y,
                                (float)((float)t[end] * (float)ray.direction.z)};
            double f = sphere(&radius, p);
            f = suite_rounded(_i, f);
            ck_assert(end == 0 ? f > 0 : f <= 0);
        }
    }
    ck_assert_int_gt(found, 150);
}

/* c - x: outside below c. */
static double ahead(const void *c, sure_vec3 p)
{
    return *(const double *)c - p.x;
}

/* The sum of the ends overflows, their middle does not. */
LOOP_TEST(test_huge_range, PLAIN_TIERS)
{
    double c = _i == SURE_TIER_FLOAT32 ? 0x1.8p127 : 0x1.8p1023, t[2];
    sure_ray ray = {{0, 0, 0}, {1, 0, 0}, c / 1.5, c * 1.25};
    ck_assert_int_eq(brackets[_i](ahead, &c, &ray, 1, t), SURE_HIT);
    ck_double_same(t[1], c);
}

/* What is met at the very end of the range, which from + (to - from) falls short of. */
LOOP_TEST(test_last_step, PLAIN_TIERS)
{
    const bool singles = _i == SURE_TIER_FLOAT32;
    const double from = singles ? 0x1.9ccdd4p-1 : 0x1.77fc19dd1d408p-3;
    const double to = singles ? 0x1.b55f96p+1 : 0x1.799e59e6179fdp+1;
    const sure_ray ray = {{0, 0, 0}, {1, 0, 0}, from, to};
    for (int steps = 1; steps <= 4; steps++) {
        double t[2];
        ck_assert_int_eq(brackets[_i](ahead, &to, &ray, steps, t), SURE_HIT);
        ck_double_same(t[1], to);
    }
}

static double beside(const void *c, sure_vec3 p)
{
    return fabs(p.z - *(const double *)c) - 0.4;
}

/* Steps that are closer than the tier's reals end where the range does. */
LOOP_TEST(test_many_steps, PLAIN_TIERS)
{
    const double c = 8388611;
    double t[2];
    const sure_ray ray = {{0, 0, 0}, {0, 0, 1}, 1.5, c};
    ck_assert_int_eq(brackets[_i](beside, &c, &ray, 1 << 25, t), SURE_HIT);
    ck_assert(t[0] < t[1] && t[1] <= c);
    ck_assert(beside(&c, (sure_vec3){0, 0, t[0]}) > 0 && beside(&c, (sure_vec3){0, 0, t[1]}) <= 0);
}

/* What is asked on entry is asked of the tier's reals. */
LOOP_TEST(test_entry, PLAIN_TIERS)
{
    const double c = 1;
    const sure_status expected = _i == SURE_TIER_FLOAT32 ? SURE_INVALID : SURE_MISS;
    const sure_ray rays[] = {{{5, 5, 5}, {1e-60, 0, 0}, 0, 1},
                             {{1e300, 0, 0}, {1, 0, 0}, 0, 1},
                             {{5, 0, 0}, {1, 0, 0}, 0, 1e39},
                             {{5, 0, 0}, {NAN, 0, 0}, 0, 1}};
    for (int i = 0; i < 4; i++) {
        double t[2];
        ck_assert_int_eq(brackets[_i](ahead, &c, &rays[i], 2, t), i < 3 ? expected : SURE_INVALID);
    }
    double t[2];
    const sure_ray rounded = {{5, 0, 0}, {1, 0, 0}, 0, 0x1.fffffe8p127}; /* to FLT_MAX */
    ck_assert_int_eq(brackets[_i](ahead, &c, &rounded, 2, t), SURE_MISS);
}

/* Counts how often it is asked. */
static double first_asked(const void *asked, sure_vec3 p)
{
    uint64_t bits;
    ++*(int *)asked;
    memcpy(&bits, &p.x, sizeof bits);
    return bits << 1 == 0 ? 1 : -1;
}

/* The change next to 0 is found as soon as any other, flushed or not, and where t_min is -0. */
LOOP_TEST(test_least_numbers, PLAIN_TIERS *SURROUNDINGS)
{
    const int tier = _i % PLAIN_TIERS, halvings = tier == SURE_TIER_FLOAT32 ? 31 : 63;
    int asked = 0;
    double t[2] = {0, 0};
    const sure_ray ray = {{0, 0, 0}, {1, 0, 0}, -0.0, 4};
    surroundings_enter(_i / PLAIN_TIERS);
    sure_status status = brackets[tier](first_asked, &asked, &ray, 1, t);
    surroundings_enter(0);
    ck_assert_int_eq(status, SURE_HIT);
    ck_assert_int_le(asked, 2 + halvings);
    bool flushed = _i / PLAIN_TIERS >= SURROUNDINGS_MODES;
    const double least[PLAIN_TIERS] = {flushed ? 0x1p-126 : 0x1p-149,
                                       flushed ? 0x1p-1022 : 0x1p-1074,
                                       flushed ? 0x1p-1022 : 0x1p-1074};
    ck_assert_msg(t[1] == least[tier], "%a, not %a", t[1], least[tier]);
}

SUITE("bracket")
