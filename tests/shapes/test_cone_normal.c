#include "suite.h"

#include <math.h>

typedef sure_vec3 wall_normal(sure_vec3, const sure_cone *);
static wall_normal *const normals[PART_TIERS] = {sure_cone_wall_normal_float32,
                                                 sure_cone_wall_normal_textbook};

/* Height 4 and radius 3: slant 5, every length on the wall a small rational. */
static const sure_cone cone = {{0, 0, 0}, {0, 4, 0}, 3};

static sure_vec3 expected(int tier, double x, double y, double z)
{
    if (tier == SURE_TIER_FLOAT32)
        return (sure_vec3){(float)x, (float)y, (float)z};
    return (sure_vec3){x, y, z};
}

/* The generator (3, -4) has the outward normal (4, 3) / 5. */
START_TEST(test_known)
{
    ck_vector_same(normals[_i]((sure_vec3){3, 0, 0}, &cone), expected(_i, 0.8, 0.6, 0));
    ck_vector_same(normals[_i]((sure_vec3){0, 0, -3}, &cone), expected(_i, 0, 0.6, -0.8));
}
END_TEST

START_TEST(test_law_1)
{
    const sure_cone wide = {{0, -4, 0}, {0, 0, 0}, 4}; /* 45 degrees, N.N = 16 */
    for (int k = 1; k < 20; k++) {
        sure_vec3 n = normals[_i]((sure_vec3){k, -k, 0}, &wide);
        ck_assert(n.x > 0 && n.y > 0);
        ck_double_same(n.x * k + n.y * -k, 0);
        ck_double_same(n.z, 0);
    }
}
END_TEST

START_TEST(test_law_2)
{
    for (int k = -6; k < 6; k++)
        ck_vector_same(normals[_i]((sure_vec3){ldexp(3, k), 4 - ldexp(4, k), 0}, &cone),
                       expected(_i, 0.8, 0.6, 0));
}
END_TEST

/* Lengths whose squares leave the range: no direction. */
START_TEST(test_overflow)
{
    double far = _i == SURE_TIER_FLOAT32 ? 1e25 : 1e200;
    ck_vector_same(normals[_i]((sure_vec3){far, 0, 0}, &cone), (sure_vec3){0, 0, 0});
}
END_TEST

START_TEST(test_apex_and_axis)
{
    const sure_cone line = {{0, 0, 0}, {0, 4, 0}, 0};
    ck_vector_same(normals[_i](cone.apex, &cone), (sure_vec3){0, 1, 0});
    ck_vector_same(normals[_i]((sure_vec3){0, 1, 0}, &line), (sure_vec3){0, 0, 0});
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cone_normal");
    suite_add_part_tiers(suite, "known", test_known);
    suite_add_part_tiers(suite, "law 1", test_law_1);
    suite_add_part_tiers(suite, "law 2", test_law_2);
    suite_add_part_tiers(suite, "overflow", test_overflow);
    suite_add_part_tiers(suite, "apex and axis", test_apex_and_axis);
    return suite_run(suite);
}
