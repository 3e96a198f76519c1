#include "suite.h"

#include <math.h>

typedef sure_vec3 rotate(double, sure_vec3);

static rotate *const rotate_x[PLAIN_TIERS] = {sure_rotate_x_float32, sure_rotate_x_textbook,
                                              sure_rotate_x_stable};
static rotate *const rotate_y[PLAIN_TIERS] = {sure_rotate_y_float32, sure_rotate_y_textbook,
                                              sure_rotate_y_stable};
static rotate *const rotate_z[PLAIN_TIERS] = {sure_rotate_z_float32, sure_rotate_z_textbook,
                                              sure_rotate_z_stable};

static const sure_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

static double angle_of(uint64_t index)
{
    return suite_single(1, index, 3);
}

static sure_vec3 vector(uint64_t index)
{
    return (sure_vec3){suite_integer(2, index, 999), suite_integer(3, index, 999),
                       suite_integer(4, index, 999)};
}

/* The entries are the tier's own cosine and sine; here they are read off the axes. */
LOOP_TEST(test_matrices, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        double a = angle_of(i);
        double c = _i == SURE_TIER_FLOAT32 ? cosf((float)a) : cos(a);
        double s = _i == SURE_TIER_FLOAT32 ? sinf((float)a) : sin(a);
        ck_vector_same(rotate_x[_i](a, y), (sure_vec3){0, c, s});
        ck_vector_same(rotate_x[_i](a, z), (sure_vec3){0, -s, c});
        ck_vector_same(rotate_y[_i](a, z), (sure_vec3){s, 0, c});
        ck_vector_same(rotate_y[_i](a, x), (sure_vec3){c, 0, -s});
        ck_vector_same(rotate_z[_i](a, x), (sure_vec3){c, s, 0});
        ck_vector_same(rotate_z[_i](a, y), (sure_vec3){-s, c, 0});
    }
}

LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        sure_vec3 v = vector(i);
        ck_double_same(rotate_x[_i](angle_of(i), v).x, v.x);
        ck_double_same(rotate_y[_i](angle_of(i), v).y, v.y);
        ck_double_same(rotate_z[_i](angle_of(i), v).z, v.z);
        ck_vector_same(rotate_x[_i](0, v), v);
        ck_vector_same(rotate_y[_i](0, v), v);
        ck_vector_same(rotate_z[_i](0, v), v);
    }
}

/* Law 2, on the axes, where the products with 0 and 1 are exact. */
LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        double a = angle_of(i);
        sure_vec3 turned = rotate_x[_i](a, y);
        double square = _i == SURE_TIER_FLOAT32
                            ? (float)((float)(turned.y * turned.y) + (float)(turned.z * turned.z))
                            : turned.y * turned.y + turned.z * turned.z;
        sure_vec3 back = rotate_x[_i](-a, turned);
        ck_double_same(back.y, square);
        ck_double_same(back.z, 0);
    }
}

LOOP_TEST(test_law_3, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 200; i++) {
        double a = angle_of(i);
        sure_vec3 v = vector(i), by_x = rotate_x[_i](a, v);
        sure_vec3 by_y = rotate_y[_i](a, (sure_vec3){v.z, v.x, v.y});
        sure_vec3 by_z = rotate_z[_i](a, (sure_vec3){v.y, v.z, v.x});
        ck_vector_same(by_y, (sure_vec3){by_x.z, by_x.x, by_x.y});
        ck_vector_same(by_z, (sure_vec3){by_x.y, by_x.z, by_x.x});
    }
}

LOOP_TEST(test_apply, PLAIN_TIERS)
{
    sure_mat3 m = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}};
    static sure_vec3 (*const apply[PLAIN_TIERS])(const sure_mat3 *, sure_vec3) = {
        sure_rotation_apply_float32, sure_rotation_apply_textbook, sure_rotation_apply_stable};
    ck_vector_same(apply[_i](&m, (sure_vec3){1, -1, 2}), (sure_vec3){5, 11, 19});
}

SUITE("rotation")
