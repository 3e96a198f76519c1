/* SPDX-License-Identifier: MIT */
#include "quadratic_laws.h"
#include "suite.h"

typedef sure_roots quadratic(double, double, double, double *);
static quadratic *const solve[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_quadratic);

static polynomial asked;
static sure_tier asked_of;

void expect(bool holds, const char *law)
{
    if (!holds)
        ck_abort_msg("%s: %s, a %a, half_b %a, c %a", law, sure_tier_name(asked_of), asked.a,
                     asked.h, asked.c);
}

static void check(int tier, polynomial p, int k)
{
    asked = p;
    asked_of = (sure_tier)tier;
    quadratic_check(p, asked_of, k);
}

/* All integers of a small world. */
LOOP_TEST(test_world, PLAIN_TIERS)
{
    enum { LIMIT = 12, SIDE = 2 * LIMIT + 1 };
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        polynomial p = {i % SIDE - LIMIT, i / SIDE % SIDE - LIMIT, i / SIDE / SIDE - LIMIT};
        check(_i, p, i % 20);
    }
}

/* Coefficients of like size, of any size, and such that D/4 nearly or wholly cancels. */
static polynomial drawn(uint64_t i)
{
    int spread = i % 2 == 0 ? 3 : 400;
    polynomial of = {suite_double(11, i, spread), suite_double(12, i, spread),
                     suite_double(13, i, spread)};
    if (i % 8 >= 4)
        of.c = of.h / of.a * of.h;
    if (i % 16 == 15) { /* a perfect square, as large as doubles hold */
        double p = suite_integer(14, i, 1 << 25), q = suite_integer(15, i, 1 << 25);
        of.a = p * p;
        of.h = ldexp(p * q, suite_integer(16, i, 300));
        of.c = of.h / p * (of.h / p);
    }
    return of;
}

LOOP_TEST(test_drawn, PLAIN_TIERS)
{
    double big = _i == SURE_TIER_FLOAT32 ? 0x1p127 : 0x1p1023;
    check(_i, (polynomial){0, big, big}, -1); /* 2 half_b would overflow */
    for (uint64_t i = 0; i < 20000; i++) {
        polynomial p = {suite_integer(1, i, 99), suite_integer(2, i, 99), suite_integer(3, i, 99)};
        check(_i, p, suite_integer(4, i, 20));
        p = drawn(i);
        if (is_finite(p))
            check(_i, p, suite_integer(4, i, 20));
    }
}

/* The smaller root of t^2 - 2^28 t + 1 is 2^-28 (1 + 2^-56 + ...): -b/2 and the root of D/4 cancel
 * to nothing. D/4 of (1 + 2^-27) t^2 - 2 t + (1 - 2^-27) is 2^-54: that of its rounded terms is 0.
 * 2^600 (t - 1)^2 - 2^600 has squares beyond double. */
LOOP_TEST(test_stable, PLAIN_TIERS)
{
    double roots[2] = {0, 0};
    bool right = solve[_i](1, -0x1p27, 1, roots) == SURE_ROOTS_TWO && roots[0] == 0x1p-28;
    ck_assert_int_eq(right, _i == SURE_TIER_STABLE);
    right = solve[_i](1 + 0x1p-27, -1, 1 - 0x1p-27, roots) == SURE_ROOTS_TWO && roots[0] < roots[1];
    ck_assert_int_eq(right, _i == SURE_TIER_STABLE);
    right = solve[_i](0x1p600, -0x1p600, 0, roots) == SURE_ROOTS_TWO && roots[1] == 2;
    ck_assert_int_eq(right, _i == SURE_TIER_STABLE);
}

SUITE("quadratic")
