#include "suite.h"

#include <math.h>

typedef sure_status wall_hit(const sure_ray *, const sure_cylinder *, sure_hit *);
typedef sure_vec3 wall_normal(sure_vec3, const sure_cylinder *);
static wall_hit *const hits[PART_TIERS] = {sure_cylinder_wall_hit_float32,
                                           sure_cylinder_wall_hit_textbook};
static wall_normal *const normals[PART_TIERS] = {sure_cylinder_wall_normal_float32,
                                                 sure_cylinder_wall_normal_textbook};

static const sure_cylinder around_y = {{0, 0, 0}, {0, 2, 0}, 2};

static sure_ray from_to(double ox, double oy, double oz, double dx, double dy, double dz)
{
    return (sure_ray){{ox, oy, oz}, {dx, dy, dz}, 0, INFINITY};
}

/* Beyond the ends too: the wall has none. */
LOOP_TEST(test_known, PART_TIERS)
{
    sure_ray ray = from_to(-5, 77, 0, 1, 0, 0);
    sure_hit hit;
    ck_assert_int_eq(hits[_i](&ray, &around_y, &hit), SURE_HIT);
    ck_double_same(hit.t, 3);
    ck_assert_int_eq(hit.part, SURE_PART_WALL);
    ck_double_same(hit.t_error, INFINITY);
    ray = from_to(0, -9, 0, 1, 5, 0);
    ck_assert_int_eq(hits[_i](&ray, &around_y, &hit), SURE_HIT);
    ck_double_same(hit.t, 2);
    ray = from_to(-5, 77, 2, 1, -3, 0);
    ck_assert_int_eq(hits[_i](&ray, &around_y, &hit), SURE_HIT);
    ck_double_same(hit.t, 5);
    ray = from_to(-5, 0, 3, 1, 0, 0);
    hit.t = 77;
    ck_assert_int_eq(hits[_i](&ray, &around_y, &hit), SURE_MISS);
    ck_double_same(hit.t, 77);
}

LOOP_TEST(test_law_1, PART_TIERS)
{
    static const sure_vec3 axes[] = {{0, 2, 0}, {1, 0, -1}, {2, 2, 0}, {0, 0, 1}};
    int found = 0;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 n = axes[i % 4];
        double r = 1 + suite_integer(7, i, 1);
        sure_cylinder plain = {{0, 0, 0}, n, r}, swapped = {n, {0, 0, 0}, r};
        sure_cylinder moved = {{3 * n.x, 3 * n.y, 3 * n.z}, {5 * n.x, 5 * n.y, 5 * n.z}, r};
        sure_ray ray =
            from_to(suite_integer(1, i, 3), suite_integer(2, i, 3), suite_integer(3, i, 3),
                    suite_integer(4, i, 2), suite_integer(5, i, 2), suite_integer(6, i, 2));
        sure_hit a = {0}, b = {0}, c = {0};
        sure_status status = hits[_i](&ray, &plain, &a);
        ck_assert_int_eq(hits[_i](&ray, &swapped, &b), status);
        ck_assert_int_eq(hits[_i](&ray, &moved, &c), status);
        ck_double_same(b.t, a.t);
        ck_double_same(c.t, a.t);
        found += status == SURE_HIT;
    }
    ck_assert_int_gt(found, 400);
}

LOOP_TEST(test_law_2, PART_TIERS)
{
    for (int x = -3; x <= 3; x++) {
        for (int z = -3; z <= 3; z++) {
            sure_ray ray = from_to(x, 9, z, 0, -1, 0);
            sure_hit hit;
            sure_status expected = x * x + z * z == 4 ? SURE_HIT : SURE_MISS;
            ray.t_min = 1.5;
            ck_assert_int_eq(hits[_i](&ray, &around_y, &hit), expected);
            if (expected == SURE_HIT)
                ck_double_same(hit.t, 1.5);
        }
    }
}

LOOP_TEST(test_normal, PART_TIERS)
{
    ck_vector_same(normals[_i]((sure_vec3){0, 8, -2}, &around_y), (sure_vec3){0, 0, -1});
    ck_vector_same(normals[_i]((sure_vec3){2, -8, 0}, &around_y), (sure_vec3){1, 0, 0});
    ck_vector_same(normals[_i]((sure_vec3){0, -8, 0}, &around_y), (sure_vec3){0, 0, 0});
    if (_i != SURE_TIER_FLOAT32)
        ck_vector_same(normals[_i]((sure_vec3){3, 1, 4}, &around_y), (sure_vec3){0.6, 0, 0.8});
}

LOOP_TEST(test_invalid, PART_TIERS)
{
    sure_ray still = from_to(0, 0, 0, 0, 0, 0), ray = from_to(-5, 0, 0, 1, 0, 0);
    sure_cylinder flat = {{1, 2, 3}, {1, 2, 3}, 1};
    sure_hit hit;
    ck_assert_int_eq(hits[_i](&still, &around_y, &hit), SURE_INVALID);
    ck_assert_int_eq(hits[_i](&ray, &flat, &hit), SURE_INVALID);
}

SUITE("cylinder_wall")
