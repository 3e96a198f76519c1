#include "suite.h"

#include <math.h>

typedef sure_status bracket(sure_implicit *, const void *, const sure_ray *, int, double *);
static bracket *const brackets[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_bracket);

/* |P|^2 - r^2, the unit-less sphere at the origin. */
static double sphere(const void *radius, sure_vec3 p)
{
    double r = *(const double *)radius;
    return p.x * p.x + p.y * p.y + p.z * p.z - r * r;
}

static const sure_ray along_x = {{-4, 0, 0}, {1, 0, 0}, 0, 8};

static double next(int tier, double t)
{
    return tier == SURE_TIER_FLOAT32 ? nextafterf((float)t, INFINITY) : nextafter(t, INFINITY);
}

LOOP_TEST(test_known, PLAIN_TIERS)
{
    double radius = 1, t[2];
    ck_assert_int_eq(brackets[_i](sphere, &radius, &along_x, 16, t), SURE_HIT);
    ck_double_same(t[1], 3);
    ck_double_same(next(_i, t[0]), 3);
}

/* The sign changes in the last step, and in an only one. */
LOOP_TEST(test_last_step, PLAIN_TIERS)
{
    double radius = 1, t[2];
    sure_ray ray = along_x;
    ray.t_max = 4;
    for (int steps = 1; steps <= 4; steps++) {
        ck_assert_int_eq(brackets[_i](sphere, &radius, &ray, steps, t), SURE_HIT);
        ck_double_same(t[1], 3);
    }
}

/* Where f is zero at P_n+1 itself the strict sign change of the notes would pass it by. */
LOOP_TEST(test_zero_at_a_step, PLAIN_TIERS)
{
    double radius = 1, t[2];
    ck_assert_int_eq(brackets[_i](sphere, &radius, &along_x, 8, t), SURE_HIT);
    ck_double_same(t[1], 3);
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

LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    double radius = 1, t[2] = {7, 7};
    const sure_ray inside = {{0, 0, 0}, {1, 0, 0}, 0, 8}, on = {{-1, 0, 0}, {-1, 0, 0}, 0, 8};
    ck_assert_int_eq(brackets[_i](sphere, &radius, &inside, 8, t), SURE_MISS);
    ck_assert_int_eq(brackets[_i](sphere, &radius, &on, 8, t), SURE_MISS);
    ck_double_same(t[0], 7);
    ck_double_same(t[1], 7);
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

/* What the method cannot see: a crossing and its return within one step. */
LOOP_TEST(test_unseen, PLAIN_TIERS)
{
    double radius = 1, t[2] = {7, 7};
    ck_assert_int_eq(brackets[_i](sphere, &radius, &along_x, 1, t), SURE_MISS);
    ck_assert_int_eq(brackets[_i](sphere, &radius, &along_x, 2, t), SURE_HIT);
}

LOOP_TEST(test_invalid, PLAIN_TIERS)
{
    double radius = 1, t[2] = {7, 7};
    sure_ray endless = along_x, still = along_x;
    endless.t_max = INFINITY;
    still.direction.x = 0;
    ck_assert_int_eq(brackets[_i](sphere, &radius, &endless, 8, t), SURE_INVALID);
    ck_assert_int_eq(brackets[_i](sphere, &radius, &still, 8, t), SURE_INVALID);
    ck_assert_int_eq(brackets[_i](sphere, &radius, &along_x, 0, t), SURE_INVALID);
    ck_double_same(t[0], 7);
    ck_double_same(t[1], 7);
}

SUITE("bracket")
