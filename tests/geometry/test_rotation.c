/* SPDX-License-Identifier: MIT */
#include "rotation_laws.h"
#include "suite.h"

#include "../../src/geometry/coordinate.h"

#include <math.h>

static const sure_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

static double angle_of(uint64_t index)
{
    return suite_single(1, index, 3);
}

/* The entries are the tier's own cosine and sine; here they are read off the axes. */
LOOP_TEST(test_matrices, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        double a = angle_of(i);
        double c = _i == SURE_TIER_FLOAT32 ? cosf((float)a) : cos(a);
        double s = _i == SURE_TIER_FLOAT32 ? sinf((float)a) : sin(a);
        turn *about_x = turn_of(0, (sure_tier)_i), *about_y = turn_of(1, (sure_tier)_i);
        turn *about_z = turn_of(2, (sure_tier)_i);
        ck_vector_same(about_x(a, y), (sure_vec3){0, c, s});
        ck_vector_same(about_x(a, z), (sure_vec3){0, -s, c});
        ck_vector_same(about_y(a, z), (sure_vec3){s, 0, c});
        ck_vector_same(about_y(a, x), (sure_vec3){c, 0, -s});
        ck_vector_same(about_z(a, x), (sure_vec3){c, s, 0});
        ck_vector_same(about_z(a, y), (sure_vec3){-s, c, 0});
    }
}

LOOP_TEST(test_laws, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        const char *broken = turn_law_broken((sure_tier)_i, angle_of(i), suite_integers(2, i, 999));
        ck_assert_msg(!broken, "%s: vector %lu", broken, (unsigned long)i);
    }
}

typedef sure_vec3 of_matrix(const sure_mat3 *, sure_vec3);
static of_matrix *const apply[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_rotation_apply);
static of_matrix *const undo[PLAIN_TIERS] = OF_PLAIN_TIERS(sure_rotation_undo);

LOOP_TEST(test_matrix, PLAIN_TIERS)
{
    sure_mat3 m = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}};
    ck_vector_same(apply[_i](&m, (sure_vec3){1, -1, 2}), (sure_vec3){5, 11, 19});
    ck_vector_same(undo[_i](&m, (sure_vec3){1, -1, 2}), (sure_vec3){11, 13, 17});
}

/* A sum of two terms overflows, that of all three does not. */
TEST(test_overflow)
{
    const sure_mat3 m = {{{0.75, 0.75, -0.5}, {0.75, 0.75, -0.5}, {-0.5, -0.5, 1}}};
    const sure_vec3 v = {0x1.8p1023, 0x1.8p1023, 0x1.8p1023}, expected = {v.x, v.x, 0};
    ck_vector_same(sure_rotation_apply_stable(&m, v), expected);
    ck_vector_same(sure_rotation_undo_stable(&m, v), expected);
}

LOOP_TEST(test_not_finite, PLAIN_TIERS)
{
    const double bad[] = {INFINITY, -INFINITY, NAN};
    const sure_mat3 one = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int i = 0; i < 9; i++) {
        sure_vec3 v = {1, 2, 3};
        sure_mat3 m = one;
        *coordinate_of(&v, i % 3) = bad[i / 3];
        *coordinate_of(&m.row[0], i % 3) = bad[i / 3];
        for (int back = 0; back < 2; back++) {
            of_matrix *through = back ? undo[_i] : apply[_i];
            sure_vec3 of_v = through(&one, v), of_m = through(&m, (sure_vec3){1, 2, 3});
            ck_assert(!isfinite(of_v.x) && !isfinite(of_v.y) && !isfinite(of_v.z));
            ck_assert(!isfinite(coordinate(of_m, back ? i % 3 : 0)));
        }
    }
}

SUITE("rotation")
