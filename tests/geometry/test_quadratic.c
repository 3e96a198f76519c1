#include "suite.h"

#include <math.h>
#include <stdbool.h>

typedef sure_roots quadratic(double, double, double, double *);
static quadratic *const solve[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_quadratic);

/* Law 1 over all integers of a small world: the count by the exact discriminant; where its root is
 * an integer the roots are rational, and quotients of doubles round to float as once. */
LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    enum { LIMIT = 12 };
    for (int a = -LIMIT; a <= LIMIT; a++) {
        for (int h = -LIMIT; h <= LIMIT; h++) {
            for (int c = -LIMIT; c <= LIMIT; c++) {
                double roots[2] = {77, 77};
                sure_roots count = solve[_i](a, h, c, roots);
                int quarter = h * h - a * c;
                if (a == 0 && h == 0) {
                    ck_assert_int_eq(count, c == 0 ? SURE_ROOTS_ALL : SURE_ROOTS_NONE);
                    ck_double_same(roots[0], 77);
                } else if (a == 0) {
                    ck_assert_int_eq(count, SURE_ROOTS_ONE);
                    ck_double_same(roots[0], suite_rounded(_i, -c / (2.0 * h)));
                    ck_double_same(roots[1], 77);
                } else if (quarter < 0) {
                    ck_assert_int_eq(count, SURE_ROOTS_NONE);
                    ck_double_same(roots[0], 77);
                    ck_double_same(roots[1], 77);
                } else {
                    int s = (int)lround(sqrt(quarter));
                    ck_assert_int_eq(count, SURE_ROOTS_TWO);
                    ck_assert(roots[0] <= roots[1]);
                    ck_assert_int_eq(roots[0] == roots[1], quarter == 0);
                    if (s * s != quarter)
                        continue;
                    double p = suite_rounded(_i, (double)(-h - s) / a),
                           q = suite_rounded(_i, (double)(-h + s) / a);
                    ck_double_same(roots[0], fmin(p, q));
                    ck_double_same(roots[1], fmax(p, q));
                }
            }
        }
    }
}

/* 2 half_b would overflow. */
LOOP_TEST(test_linear, PLAIN_TIERS)
{
    double big = _i == SURE_TIER_FLOAT32 ? 0x1p127 : 0x1p1023, roots[2];
    ck_assert_int_eq(solve[_i](0, big, big, roots), SURE_ROOTS_ONE);
    ck_double_same(roots[0], -0.5);
}

/* Is the root x within SURE_ROOT_ULPS of the larger root? For integers and x of the tier: the
 * polynomial changes sign, or is zero, between the ends of that interval, exactly (long double
 * holds it). */
static int close(int tier, int a, int h, int c, double x, double larger)
{
    int exponent;
    (void)frexp(larger, &exponent);
    double step = ldexp(SURE_ROOT_ULPS, exponent - (tier == SURE_TIER_FLOAT32 ? 24 : 53));
    long double low = (long double)x - step, high = (long double)x + step;
    long double f = (a * low + 2 * h) * low + c, g = (a * high + 2 * h) * high + c;
    long double vertex = -(long double)h / a;
    return (f <= 0 && g >= 0) || (f >= 0 && g <= 0) || (low <= vertex && vertex <= high);
}

LOOP_TEST(test_bound, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 20000; i++) {
        int a = suite_integer(1, i, 99), h = suite_integer(2, i, 99), c = suite_integer(3, i, 99);
        double roots[2];
        if (a == 0 || solve[_i](a, h, c, roots) != SURE_ROOTS_TWO)
            continue;
        double larger = fmax(fabs(roots[0]), fabs(roots[1]));
        ck_assert(close(_i, a, h, c, roots[0], larger));
        ck_assert(close(_i, a, h, c, roots[1], larger));
    }
}

LOOP_TEST(test_laws_2_and_3, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 20000; i++) {
        double a = suite_single(1, i, 6), h = suite_single(2, i, 6);
        double c = suite_single(3, i, 6), k = ldexp(1, suite_integer(4, i, 20));
        double plain[2] = {0, 0}, other[2] = {0, 0};
        sure_roots count = solve[_i](a, h, c, plain);
        ck_assert_int_eq(solve[_i](-a, -h, -c, other), count);
        ck_double_same(other[0], plain[0]);
        ck_double_same(other[1], plain[1]);
        ck_assert_int_eq(solve[_i](k * a, k * h, k * c, other), count);
        ck_double_same(other[0], plain[0]);
        ck_double_same(other[1], plain[1]);
        ck_assert_int_eq(solve[_i](a, -h, c, other), count);
        ck_double_same(other[0], -plain[1]);
        ck_double_same(other[1], -plain[0]);
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
