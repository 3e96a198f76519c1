/* SPDX-License-Identifier: MIT */
#include "suite.h"
#include "tiers.h"

typedef sure_vec3 wall_normal(sure_vec3, const sure_cone *);
static wall_normal *const normals[PART_TIERS] = {sure_cone_wall_normal_float32,
                                                 sure_cone_wall_normal_textbook};

/* Height 4 and radius 3: slant 5, every length on the wall a small rational. */
static const sure_cone cone = {{0, 0, 0}, {0, 4, 0}, 3};

static sure_vec3 expected(int tier, double x, double y, double z)
{
    return rounded_vector((sure_tier)tier, (sure_vec3){x, y, z});
}

/* The generator (3, -4) has the outward normal (4, 3) / 5. */
LOOP_TEST(test_known, PART_TIERS)
{
    ck_vector_same(normals[_i]((sure_vec3){3, 0, 0}, &cone), expected(_i, 0.8, 0.6, 0));
    ck_vector_same(normals[_i]((sure_vec3){0, 0, -3}, &cone), expected(_i, 0, 0.6, -0.8));
}

/* Lengths whose squares leave the range: no direction. */
LOOP_TEST(test_overflow, PART_TIERS)
{
    double far = _i == SURE_TIER_FLOAT32 ? 1e25 : 1e200;
    const sure_cone longest = {{0, -DBL_MAX, 0}, {0, DBL_MAX, 0}, 1};
    ck_vector_same(normals[_i]((sure_vec3){far, 0, 0}, &cone), (sure_vec3){0, 0, 0});
    ck_vector_same(normals[_i](longest.apex, &longest), (sure_vec3){0, 0, 0});
}

LOOP_TEST(test_apex_and_axis, PART_TIERS)
{
    const sure_cone line = {{0, 0, 0}, {0, 4, 0}, 0};
    ck_vector_same(normals[_i](cone.apex, &cone), (sure_vec3){0, 1, 0});
    ck_vector_same(normals[_i]((sure_vec3){0, 1, 0}, &line), (sure_vec3){0, 0, 0});
}

SUITE("cone_normal")
