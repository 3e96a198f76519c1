#include "suite.h"
#include "viewport.h"

#include <math.h>
#include <mpfr.h>

static double (*const extent[SURE_TIERS])(double, double) = {sure_viewport_extent_float32,
                                                             sure_viewport_extent_textbook};

/* The formula, term by term in the tier's precision. */
START_TEST(test_formula)
{
    for (int fov = 1; fov < 180; fov++) {
        double expected =
            _i == SURE_TIER_FLOAT32
                ? 2 * tanf((float)3.14159265358979323846 / 360 * (float)fov)
                : 2 * tan(3.14159265358979323846 / 360 * fov);
        ck_double_same(extent[_i](1, fov), expected);
    }
}
END_TEST

START_TEST(test_law_1)
{
    for (int fov = 1; fov < 180; fov += 7)
        ck_double_same(extent[_i](8, fov), 8 * extent[_i](1, fov));
}
END_TEST

START_TEST(test_law_2)
{
    for (int fov = 1; fov < 179; fov++)
        ck_assert(extent[_i](1, fov) < extent[_i](1, fov + 1));
}
END_TEST

/* The tracer's extent against pi, division and tangent in 300 bits. */
START_TEST(test_rounded)
{
    mpfr_t x;
    mpfr_init2(x, 300);
    for (uint64_t i = 0; i < 2000; i++) {
        double fov = fabs(suite_double(1, i, 7));
        fov = fov < 180 ? fov : 180 - fov / 1024;
        mpfr_const_pi(x, MPFR_RNDN);
        mpfr_mul_d(x, x, fov, MPFR_RNDN);
        mpfr_div_ui(x, x, 360, MPFR_RNDN);
        mpfr_tan(x, x, MPFR_RNDN);
        ck_double_same(viewport_extent(1, fov), 2 * mpfr_get_d(x, MPFR_RNDN));
    }
    mpfr_clear(x);
    ck_double_same(viewport_extent(1, 90), 2);
    ck_double_same(viewport_extent(0.5, 90), 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("viewport");
    suite_add_tiers(suite, "formula", test_formula);
    suite_add_tiers(suite, "law 1", test_law_1);
    suite_add_tiers(suite, "law 2", test_law_2);
    TCase *rounded = tcase_create("rounded");
    tcase_add_test(rounded, test_rounded);
    suite_add_tcase(suite, rounded);
    return suite_run(suite);
}
