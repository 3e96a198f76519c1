#include "suite.h"

#include <math.h>
#include <stdlib.h>

typedef sure_status wall_hit(const sure_ray *, const sure_cone *, sure_hit *);
static wall_hit *const hits[PART_TIERS] = {sure_cone_wall_hit_float32, sure_cone_wall_hit_textbook};

/* Apex at the origin, both nappes around y, at 45 degrees: x^2 + z^2 = y^2. */
static const sure_cone upright = {{0, -2, 0}, {0, 0, 0}, 2};

static sure_ray from_to(double ox, double oy, double oz, double dx, double dy, double dz)
{
    return (sure_ray){{ox, oy, oz}, {dx, dy, dz}, 0, INFINITY};
}

static double first(int tier, sure_ray ray, const sure_cone *cone)
{
    sure_hit hit = {.t = -1};
    if (hits[tier](&ray, cone, &hit) == SURE_HIT) {
        ck_assert_int_eq(hit.part, SURE_PART_WALL);
        ck_double_same(hit.t_error, INFINITY);
    }
    return hit.t;
}

LOOP_TEST(test_known, PART_TIERS)
{
    ck_double_same(first(_i, from_to(-9, -3, 0, 1, 0, 0), &upright), 6);
    ck_double_same(first(_i, from_to(-9, 3, 0, 1, 0, 0), &upright), 6); /* the other nappe */
    ck_double_same(first(_i, from_to(0, -3, 0, 1, 0, 0), &upright), 3);
    ck_double_same(first(_i, from_to(-9, 0, 0, 1, 0, 0), &upright), 9); /* the apex */
    ck_double_same(first(_i, from_to(-9, 0, 1, 1, 0, 0), &upright), -1);
    ck_double_same(first(_i, from_to(1, 5, 0, 0, -1, 0), &upright), 4); /* a < 0 */
    ck_double_same(first(_i, from_to(1, 0, 0, 0, -1, 0), &upright), 1);
    ck_double_same(first(_i, from_to(1, 0, 0, 1, 1, 0), &upright), -1);   /* a = 0, root behind */
    ck_double_same(first(_i, from_to(-1, 0, 0, 1, 1, 0), &upright), 0.5); /* a = 0 */
    ck_double_same(first(_i, from_to(0, 1, 0, 1, 1, 0), &upright), -1); /* a = 0, inside for good */
}

/* At half the depth the wall is at half the radius, whatever the angle. */
LOOP_TEST(test_angle, PART_TIERS)
{
    const sure_cone steep = {{0, -4, 0}, {0, 0, 0}, 3}, flat = {{0, -2, 0}, {0, 0, 0}, 8};
    ck_double_same(first(_i, from_to(-5, -2, 0, 1, 0, 0), &steep), 3.5);
    ck_double_same(first(_i, from_to(-5, -1, 0, 1, 0, 0), &flat), 1);
}

LOOP_TEST(test_law_1, PART_TIERS)
{
    int found = 0;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_cone cone = {{0, -2, 0}, {0, 0, 0}, 1 + suite_integer(7, i, 1)};
        sure_cone other = cone;
        other.base.y = 2;
        sure_ray ray = from_to(suite_integer(1, i, 3), suite_integer(2, i, 3),
                               suite_integer(3, i, 3), suite_integer(4, i, 2),
                               suite_integer(5, i, 2), 1 + abs(suite_integer(6, i, 1)));
        double t = first(_i, ray, &cone);
        ck_double_same(first(_i, ray, &other), t);
        found += t >= 0;
    }
    ck_assert_int_gt(found, 500);
}

LOOP_TEST(test_law_2, PART_TIERS)
{
    sure_ray ray = from_to(0, 5, 5, 0, -1, -1);
    ray.t_min = 2.5;
    ck_double_same(first(_i, ray, &upright), 2.5);
}

LOOP_TEST(test_invalid, PART_TIERS)
{
    sure_ray ray = from_to(-5, 0, 0, 1, 0, 0);
    sure_cone flat = {{1, 2, 3}, {1, 2, 3}, 1};
    sure_hit hit;
    ck_assert_int_eq(hits[_i](&ray, &flat, &hit), SURE_INVALID);
}

SUITE("cone_wall")
