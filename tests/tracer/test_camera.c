#include "camera_laws.h"
#include "suite.h"

#include <math.h>

typedef sure_status camera_rotation(sure_vec3, sure_mat3 *);
static camera_rotation *const rotation[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_camera_rotation);

static void ck_matrix_same(sure_mat3 m, sure_vec3 r0, sure_vec3 r1, sure_vec3 r2)
{
    ck_vector_same(m.row[0], r0);
    ck_vector_same(m.row[1], r1);
    ck_vector_same(m.row[2], r2);
}

/* Case 7, (0, y, z) about x: c = -z/rho, s = -y/rho, and case 8, (x, 0, z) about y: s = x/rho, in
 * all four quadrants. About x first about y where it looks along +z. */
LOOP_TEST(test_about_x_and_y, PLAIN_TIERS)
{
    for (int signs = 0; signs < 4; signs++) {
        double side = signs & 1 ? 0.75 : -0.75, z = signs & 2 ? 1 : -1, turn = z > 0 ? -1 : 1;
        double c = suite_rounded(_i, 0.8), s = suite_rounded(_i, side > 0 ? 0.6 : -0.6);
        sure_mat3 m;
        ck_assert_int_eq(rotation[_i]((sure_vec3){0, side, z}, &m), SURE_HIT);
        ck_matrix_same(m, (sure_vec3){turn, 0, 0}, (sure_vec3){0, c, turn * s},
                       (sure_vec3){0, -s, turn * c});
        c *= turn;
        ck_assert_int_eq(rotation[_i]((sure_vec3){side, 0, z}, &m), SURE_HIT);
        ck_matrix_same(m, (sure_vec3){c, 0, s}, (sure_vec3){0, 1, 0}, (sure_vec3){-s, 0, c});
    }
}

/* The general vector, built so that every entry is a quotient that is exact: (x, z) of length 5/4
 * and (rho, y) of length 25/16 give cosines 4/5; what it looks at comes to lie straight ahead. */
LOOP_TEST(test_general, PLAIN_TIERS)
{
    sure_vec3 view = {0.75, -0.9375, -1};
    sure_mat3 m;
    ck_assert_int_eq(rotation[_i](view, &m), SURE_HIT);
    if (_i != SURE_TIER_FLOAT32)
        ck_matrix_same(m, (sure_vec3){0.8, 0, 0.6}, (sure_vec3){0.6 * 0.6, 0.8, -(0.6 * 0.8)},
                       (sure_vec3){-(0.8 * 0.6), 0.6, 0.8 * 0.8});
    ck_assert(m.row[2].x < 0 && m.row[2].y > 0 && m.row[2].z > 0);
    ck_assert(m.row[1].y > 0); /* up stays up */
}

/* Every law, and so where the view goes and that the rows are a rotation's, of no view, of those
 * along an axis, and of general vectors of any sizes, all three coordinates as far apart as they
 * come. */
LOOP_TEST(test_laws, PLAIN_TIERS)
{
    const int spread[] = {3, _i == SURE_TIER_FLOAT32 ? 120 : 1000, 0};
    const sure_vec3 odd[] = {{0, 0, 0}, {-0.0, 0, -0.0}, {NAN, 0, 1}, {0, INFINITY, 1}, {0, 0, -1},
                             {0, 0, 1}, {-1, 0, 0},      {1, 0, 0},   {0, -1, 0},       {0, 1, 0}};
    const uint64_t odds = sizeof odd / sizeof *odd;
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 v = {suite_double(11, i, spread[i % 3]), suite_double(12, i, spread[i / 3 % 3]),
                       suite_double(13, i, spread[i / 9 % 3])};
        if (i < odds)
            v = odd[i];
        const char *broken = rotation_law_broken((sure_tier)_i, v, suite_integer(14, i, 80));
        ck_assert_msg(!broken, "%s: (%a, %a, %a)", broken, v.x, v.y, v.z);
    }
}

/* Squares that over- or underflow; a view that is nearly straight down keeps its roll. */
LOOP_TEST(test_extremes, PLAIN_TIERS)
{
    double big = _i == SURE_TIER_FLOAT32 ? 1e38 : 1e300;
    double small = _i == SURE_TIER_FLOAT32 ? 1e-44 : 0x1p-1074;
    sure_mat3 m, n;
    ck_assert_int_eq(rotation[_i]((sure_vec3){3, 0, -4}, &n), SURE_HIT);
    ck_assert_int_eq(rotation[_i]((sure_vec3){0.75 * big, 0, -big}, &m), SURE_HIT);
    if (_i != SURE_TIER_FLOAT32)
        ck_matrix_same(m, n.row[0], n.row[1], n.row[2]);
    ck_assert_int_eq(rotation[_i]((sure_vec3){small, 0, 0}, &m), SURE_HIT);
    ck_matrix_same(m, (sure_vec3){0, 0, 1}, (sure_vec3){0, 1, 0}, (sure_vec3){-1, 0, 0});
    ck_assert_int_eq(rotation[_i]((sure_vec3){small, -1, 0}, &m), SURE_HIT);
    ck_matrix_same(m, (sure_vec3){0, 0, 1}, (sure_vec3){1, 0, 0}, (sure_vec3){0, 1, 0});
}

SUITE("camera")
