#include "objects.h"
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

/* Of any cone, its apex in the origin, so that a point of the wall is off it by u of itself: by the
 * roundings that tests/oracles/part_check.c counts, 48 u s / r of the normal, and by the point's
 * own, another u s / r in each coordinate. */
#define LAW_ROUNDINGS 52

static sure_vec3 across(sure_vec3 axis, sure_vec3 any)
{
    sure_vec3 v = cross(axis, any);
    return times(1 / sqrt(dot(v, v)), v);
}

LOOP_TEST(test_laws_of_any_cone, PART_TIERS)
{
    const sure_vec3 origin = {0, 0, 0};
    const double u = _i == SURE_TIER_FLOAT32 ? 0x1p-24 : 0x1p-53;
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 axis = rounded_vector((sure_tier)_i, suite_doubles(1, i, 3)); /* to the base */
        double r = suite_rounded(_i, fabs(suite_double(4, i, 3))), h = sqrt(dot(axis, axis));
        const sure_cone any = {axis, origin, r};
        double depth = fabs(suite_double(5, i, 2)), k = 1 + fabs(suite_double(6, i, 2));
        sure_vec3 way = times(depth, plus(axis, times(r, across(axis, suite_doubles(7, i, 1)))));
        sure_vec3 p = rounded_vector((sure_tier)_i, way);
        sure_vec3 q = rounded_vector((sure_tier)_i, times(k, way));
        sure_vec3 n = normals[_i](p, &any), m = normals[_i](q, &any);
        double off = LAW_ROUNDINGS * u * sqrt(h * h + r * r) / r, length = sqrt(dot(p, p));
        ck_assert_msg(fabs(dot(n, p)) <= off * length, "Law 1: %g, allowed %g", dot(n, p) / length,
                      off);
        sure_vec3 apart = minus(n, m);
        ck_assert_msg(sqrt(dot(apart, apart)) <= 2 * sqrt(3) * off, "Law 2: %g, allowed %g",
                      sqrt(dot(apart, apart)), off);
        ck_assert(dot(n, axis) <= off * h); /* the base lies below */
    }
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
