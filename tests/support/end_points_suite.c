#include "end_points_suite.h"

#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <string.h>

static void check_known(const end_points_stem *stem)
{
    sure_vec3 ends[2];
    ck_assert_int_eq(stem->make((sure_vec3){1, 2, 3}, (sure_vec3){0, 5, 0}, 1, 6, ends),
                     SURE_FIELD_NONE);
    ck_vector_same(ends[0], (sure_vec3){1, -1, 3});
    ck_vector_same(ends[1], (sure_vec3){1, 5, 3});
    ck_assert_int_eq(stem->make((sure_vec3){0, 0, 0}, (sure_vec3){3, 0, -4}, 0, 20, ends),
                     SURE_FIELD_NONE);
    ck_vector_same(ends[0], (sure_vec3){-6, 0, 8});
    ck_vector_same(ends[1], (sure_vec3){6, 0, -8});
}

static sure_vec3 vector(uint64_t stream, uint64_t index, int spread)
{
    return (sure_vec3){suite_single(stream, index, spread),
                       suite_single(stream + 1, index, spread),
                       suite_single(stream + 2, index, spread)};
}

static void check_laws(const end_points_stem *stem, int tier)
{
    int most = tier == SURE_TIER_FLOAT32 ? 30 : 900;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 c = vector(1, i, 4), n = vector(4, i, 4);
        sure_vec3 turned = {-n.x, -n.y, -n.z};
        int k = suite_integer(7, i, most);
        sure_vec3 longer = {ldexp(n.x, k), ldexp(n.y, k), ldexp(n.z, k)};
        sure_vec3 plain[2], law_1[2], law_2[2];
        ck_assert_int_eq(stem->make(c, n, 1, 2, plain), SURE_FIELD_NONE);
        ck_assert_int_eq(stem->make(c, turned, 1, 2, law_1), SURE_FIELD_NONE);
        ck_vector_same(law_1[0], plain[1]);
        ck_vector_same(law_1[1], plain[0]);
        ck_assert_int_eq(stem->make(c, longer, 1, 2, law_2), SURE_FIELD_NONE);
        ck_vector_same(law_2[0], plain[0]);
        ck_vector_same(law_2[1], plain[1]);
    }
}

/* |value - (c + share n / |n|)| in ulps of the larger of |c| and h/2. */
static double error_ulps(double value, double c, double share, double n, sure_vec3 axis,
                         double half_height)
{
    int exponent;
    mpfr_t x, length;
    mpfr_inits2(300, x, length, (mpfr_ptr)0);
    mpfr_set_d(length, axis.x, MPFR_RNDN);
    mpfr_sqr(length, length, MPFR_RNDN);
    mpfr_set_d(x, axis.y, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_add(length, length, x, MPFR_RNDN);
    mpfr_set_d(x, axis.z, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_add(length, length, x, MPFR_RNDN);
    mpfr_sqrt(length, length, MPFR_RNDN);
    mpfr_set_d(x, n, MPFR_RNDN);
    mpfr_mul_d(x, x, share, MPFR_RNDN);
    mpfr_div(x, x, length, MPFR_RNDN);
    mpfr_add_d(x, x, c, MPFR_RNDN);
    mpfr_sub_d(x, x, value, MPFR_RNDN);
    (void)frexp(fmax(fabs(c), half_height), &exponent);
    double ulps = fabs(ldexp(mpfr_get_d(x, MPFR_RNDA), 53 - exponent));
    mpfr_clears(x, length, (mpfr_ptr)0);
    return ulps;
}

static void check_bound(const end_points_stem *stem)
{
    double worst = 0;
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 c = {suite_double(1, i, 6), suite_double(2, i, 6), suite_double(3, i, 6)};
        sure_vec3 n = {suite_double(4, i, 6), suite_double(5, i, 6), suite_double(6, i, 6)};
        double height = fabs(suite_double(7, i, 6));
        sure_vec3 ends[2];
        ck_assert_int_eq(stem->make(c, n, 1, height, ends), SURE_FIELD_NONE);
        for (int e = 0; e < 2; e++) {
            double share = (e == 0 ? -height : height) / 2;
            worst = fmax(worst, error_ulps(ends[e].x, c.x, share, n.x, n, height / 2));
            worst = fmax(worst, error_ulps(ends[e].y, c.y, share, n.y, n, height / 2));
            worst = fmax(worst, error_ulps(ends[e].z, c.z, share, n.z, n, height / 2));
        }
    }
    ck_assert_msg(worst <= SURE_END_POINT_ULPS, "%g ulps", worst);
    ck_assert_msg(worst > 0.5, "only %g ulps: is anything measured?", worst);
}

static void refused(const end_points_stem *stem, sure_vec3 centre, sure_vec3 axis, double radius,
                    double height, sure_field expected)
{
    sure_vec3 ends[2] = {{7, 7, 7}, {7, 7, 7}}, before[2] = {{7, 7, 7}, {7, 7, 7}};
    ck_assert_int_eq(stem->make(centre, axis, radius, height, ends), expected);
    ck_assert(memcmp(ends, before, sizeof ends) == 0);
}

static void check_invalid(const end_points_stem *stem)
{
    const sure_vec3 zero = {0, 0, 0}, y = {0, 1, 0};
    refused(stem, (sure_vec3){NAN, 0, 0}, y, 1, 1, SURE_FIELD_CENTRE);
    refused(stem, zero, zero, 1, 1, SURE_FIELD_NORMAL);
    refused(stem, zero, (sure_vec3){0, INFINITY, 0}, 1, 1, SURE_FIELD_NORMAL);
    refused(stem, zero, y, 1, 0, stem->upper);
    refused(stem, zero, y, 1, -1, stem->upper);
    refused(stem, zero, y, 1, NAN, stem->upper);
    refused(stem, zero, y, 1, INFINITY, stem->upper);
    refused(stem, (sure_vec3){0, 1e17, 0}, y, 1, 1, stem->upper);
    refused(stem, (sure_vec3){0, DBL_MAX, 0}, y, 1, DBL_MAX, stem->upper);
    refused(stem, zero, y, -1, 1, SURE_FIELD_RADIUS);
    refused(stem, zero, y, NAN, 1, SURE_FIELD_RADIUS);
}

static const end_points_stem *subjects;

START_TEST(test_known)
{
    check_known(&subjects[_i]);
}
END_TEST

START_TEST(test_laws)
{
    check_laws(&subjects[_i], _i);
}
END_TEST

START_TEST(test_bound)
{
    check_bound(&subjects[SURE_TIER_TEXTBOOK]);
}
END_TEST

START_TEST(test_invalid)
{
    check_invalid(&subjects[_i]);
}
END_TEST

void end_points_add(Suite *suite, const end_points_stem stems[PART_TIERS])
{
    subjects = stems;
    suite_add_part_tiers(suite, "known", test_known);
    suite_add_part_tiers(suite, "laws", test_laws);
    suite_add_part_tiers(suite, "invalid", test_invalid);
    TCase *bound = tcase_create("bound");
    tcase_add_test(bound, test_bound);
    suite_add_tcase(suite, bound);
}
