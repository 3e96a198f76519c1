/* The stable tier's promises (docs/proofs/stable.md) of what is no shape. A shape's stable is the
 * first stage of certain, which the shape's laws hold it to. */
#include "suite.h"
#include "tiers.h"

#include <math.h>
#include <mpfr.h>
#include <stdbool.h>

/* Every product and difference of doubles fits. */
enum { EXACT_BITS = 4400, QUADRATICS = 20000 };

/* (-h + sign sqrt(h^2 - a c)) / a, rounded to double; the exact sign of h^2 - a c is returned. */
static int exact_root(double a, double h, double c, int sign, double *root)
{
    mpfr_t quarter, other, top;
    mpfr_inits2(EXACT_BITS, quarter, other, top, (mpfr_ptr)0);
    mpfr_set_d(quarter, h, MPFR_RNDN);
    mpfr_sqr(quarter, quarter, MPFR_RNDN);
    mpfr_set_d(other, a, MPFR_RNDN);
    mpfr_mul_d(other, other, c, MPFR_RNDN);
    mpfr_sub(quarter, quarter, other, MPFR_RNDN);
    int count = mpfr_sgn(quarter);
    if (count >= 0) {
        mpfr_sqrt(top, quarter, MPFR_RNDN);
        mpfr_mul_si(top, top, sign, MPFR_RNDN);
        mpfr_sub_d(top, top, h, MPFR_RNDN);
        mpfr_div_d(top, top, a, MPFR_RNDN);
        *root = mpfr_get_d(top, MPFR_RNDN);
    }
    mpfr_clears(quarter, other, top, (mpfr_ptr)0);
    return count;
}

/* Is x at most `ulps` steps from the correctly rounded root, which is half a step from the root?
 * A step down across a power of two is half an ulp: such steps are counted twice. */
static bool ulps_away(double x, double root, int ulps)
{
    for (int i = 0; i < ulps; i++) {
        if (x == root)
            return true;
        root = nextafter(root, x);
    }
    return x == root;
}

/* Coefficients of like size, of any size, and such that D/4 nearly or wholly cancels. */
static void draw_quadratic(uint64_t i, double *a, double *h, double *c)
{
    int spread = i % 2 == 0 ? 3 : 400;
    *a = suite_double(11, i, spread);
    *h = suite_double(12, i, spread);
    *c = suite_double(13, i, spread);
    if (i % 8 >= 4)
        *c = *h / *a * *h;
    if (i % 16 == 15) { /* a perfect square, as large as doubles hold */
        double p = suite_integer(14, i, 1 << 25), q = suite_integer(15, i, 1 << 25);
        *a = p * p;
        *h = ldexp(p * q, suite_integer(16, i, 300));
        *c = *h / p * (*h / p);
    }
}

TEST(test_root_ulps)
{
    uint64_t counts[3] = {0, 0, 0};
    for (uint64_t i = 0; i < QUADRATICS; i++) {
        double a, h, c, low = 0, high = 0, roots[2] = {0, 0};
        draw_quadratic(i, &a, &h, &c);
        if (a == 0 || !isfinite(c))
            continue;
        int sign = a > 0 ? 1 : -1, count = exact_root(a, h, c, -sign, &low);
        (void)exact_root(a, h, c, sign, &high);
        counts[count + 1]++;
        sure_roots found = sure_quadratic_stable(a, h, c, roots);
        bool right = found == (count < 0 ? SURE_ROOTS_NONE : SURE_ROOTS_TWO) &&
                     (count < 0 || (ulps_away(roots[0], low, SURE_STABLE_ROOT_ULPS) &&
                                    ulps_away(roots[1], high, SURE_STABLE_ROOT_ULPS)));
        if (!right)
            ck_abort_msg("a %a, h %a, c %a: %a, %a, not %a, %a", a, h, c, roots[0], roots[1], low,
                         high);
    }
    ck_assert(counts[0] > QUADRATICS / 8 && counts[1] > 0 && counts[2] > QUADRATICS / 8);
}

/* Lengths of any size: what a power of two does to the arguments it does to the result, exactly. */
TEST(test_any_size)
{
    static const int powers[] = {-600, -300, 300, 600, 1000};
    for (uint64_t i = 0; i < 1000; i++) {
        int k = powers[i % 5], j = powers[i / 5 % 5];
        sure_vec3 v = suite_doubles(21, i, 2), n = suite_doubles(24, i, 2);
        sure_vec3 p = suite_doubles(27, i, 2);
        ck_vector_same(sure_project_stable(times_two_to(v, k), times_two_to(n, j)),
                       times_two_to(sure_project_stable(v, n), k));
        ck_vector_same(sure_reflect_stable(times_two_to(v, k), times_two_to(n, j)),
                       times_two_to(sure_reflect_stable(v, n), k));
        ck_double_same(
            sure_light_intensity_stable(times_two_to(p, k), times_two_to(n, j), times_two_to(v, k)),
            sure_light_intensity_stable(p, n, v));
    }
}

SUITE("stable")
