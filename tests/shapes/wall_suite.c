/* SPDX-License-Identifier: MIT */
/* The stem SUBJECT, cone_wall or cylinder_wall: the wall without ends. */
#include "suite.h"

typedef sure_status wall_hit(const sure_ray *, const sure_object *, sure_hit *);

#define WALL_HIT(shape, name)                                                                      \
    static sure_status of_##name(const sure_ray *ray, const sure_object *of, sure_hit *hit)        \
    {                                                                                              \
        return name(ray, &of->as.shape, hit);                                                      \
    }

WALL_HIT(cone, sure_cone_wall_hit_float32)
WALL_HIT(cone, sure_cone_wall_hit_textbook)
WALL_HIT(cylinder, sure_cylinder_wall_hit_float32)
WALL_HIT(cylinder, sure_cylinder_wall_hit_textbook)
WALL_HIT(cone, sure_cone_wall_hit_exact)
WALL_HIT(cylinder, sure_cylinder_wall_hit_exact)

static wall_hit *const hits[SURE_SHAPES][PART_TIERS] = {
    [SURE_SHAPE_CONE] = {of_sure_cone_wall_hit_float32, of_sure_cone_wall_hit_textbook},
    [SURE_SHAPE_CYLINDER] = {of_sure_cylinder_wall_hit_float32, of_sure_cylinder_wall_hit_textbook},
};

static const bool is_cone = SUBJECT == SURE_SHAPE_CONE;

static sure_object made(sure_vec3 base, sure_vec3 end, double radius)
{
    return (sure_object){SUBJECT, {.cylinder = {base, end, radius}}}; /* or a cone */
}

/* Where the ray meets the wall first, or -1. */
static double first(int tier, const sure_ray *ray, const sure_object *of)
{
    sure_hit hit = {.t = -1};
    sure_status status = hits[SUBJECT][tier](ray, of, &hit);
    ck_assert_int_eq(status, hit.t == -1 ? SURE_MISS : SURE_HIT);
    if (status == SURE_HIT) {
        ck_assert_int_eq(hit.part, SURE_PART_WALL);
        ck_double_same(hit.t_error, INFINITY);
    }
    return hit.t;
}

typedef struct {
    double base, end, radius; /* on the y axis */
    sure_ray ray;
    double t;
    int leaves; /* of exact */
} row;

/* At 45 degrees x^2 + z^2 = y^2, both nappes; at half the depth any wall is at half the radius. */
static const row of_cone[] = {
    {-2, 0, 2, {{-9, -3, 0}, {1, 0, 0}, 0, INFINITY}, 6, 0},
    {-2, 0, 2, {{-9, 3, 0}, {1, 0, 0}, 0, INFINITY}, 6, 0}, /* the other nappe */
    {-2, 0, 2, {{0, -3, 0}, {1, 0, 0}, 0, INFINITY}, 3, 1},
    {-2, 0, 2, {{-9, 0, 0}, {1, 0, 0}, 0, INFINITY}, 9, 0}, /* the apex */
    {-2, 0, 2, {{-9, 0, 1}, {1, 0, 0}, 0, INFINITY}, -1, 0},
    {-2, 0, 2, {{1, 5, 0}, {0, -1, 0}, 0, INFINITY}, 4, 1}, /* a < 0 */
    {-2, 0, 2, {{1, 0, 0}, {0, -1, 0}, 0, INFINITY}, 1, 0},
    {-2, 0, 2, {{1, 0, 0}, {1, 1, 0}, 0, INFINITY}, -1, 0},   /* a = 0, root behind */
    {-2, 0, 2, {{-1, 0, 0}, {1, 1, 0}, 0, INFINITY}, 0.5, 0}, /* a = 0 */
    {-2, 0, 2, {{0, 1, 0}, {1, -1, 0}, 0, INFINITY}, 0.5, 1}, /* a = 0, from inside */
    {-2, 0, 2, {{0, 1, 0}, {0, -1, 0}, 0, INFINITY}, 1, 1},   /* from one nappe to the other */
    {-2, 0, 2, {{0, 1, 0}, {1, 1, 0}, 0, INFINITY}, -1, 0},   /* a = 0, inside for good */
    {-2, 0, 2, {{0, 5, 5}, {0, -1, -1}, 2.5, INFINITY}, 2.5, 0},
    {-4, 0, 3, {{-5, -2, 0}, {1, 0, 0}, 0, INFINITY}, 3.5, 0},
    {-2, 0, 8, {{-5, -1, 0}, {1, 0, 0}, 0, INFINITY}, 1, 0},
};

/* Beyond the ends too: the wall has none. What runs along the wall meets it at once. */
static const row of_cylinder[] = {
    {0, 2, 2, {{-5, 77, 0}, {1, 0, 0}, 0, INFINITY}, 3, 0},
    {0, 2, 2, {{0, -9, 0}, {1, 5, 0}, 0, INFINITY}, 2, 1},
    {0, 2, 2, {{-5, 77, 2}, {1, -3, 0}, 0, INFINITY}, 5, 0},
    {0, 2, 2, {{-5, 0, 3}, {1, 0, 0}, 0, INFINITY}, -1, 0},
    {0, 2, 2, {{2, 9, 0}, {0, -1, 0}, 1.5, INFINITY}, 1.5, 0},
    {0, 2, 2, {{0, 9, -2}, {0, -1, 0}, 1.5, INFINITY}, 1.5, 0},
    {0, 2, 2, {{1, 9, 1}, {0, -1, 0}, 1.5, INFINITY}, -1, 0},
    {0, 2, 2, {{3, 9, 0}, {0, -1, 0}, 1.5, INFINITY}, -1, 0},
};

/* Law 2, too. */
LOOP_TEST(test_known, PART_TIERS)
{
    const row *rows = is_cone ? of_cone : of_cylinder;
    size_t size = is_cone ? sizeof of_cone : sizeof of_cylinder;
    for (const row *r = rows; r < rows + size / sizeof *r; r++) {
        const sure_object of =
            made((sure_vec3){0, r->base, 0}, (sure_vec3){0, r->end, 0}, r->radius);
        ck_double_same(first(_i, &r->ray, &of), r->t);
    }
}

/* Each t is a double, and what begins in the wall has no error. */
TEST(test_exact)
{
    const row *rows = is_cone ? of_cone : of_cylinder;
    size_t size = is_cone ? sizeof of_cone : sizeof of_cylinder;
    for (const row *r = rows; r < rows + size / sizeof *r; r++) {
        const sure_object of =
            made((sure_vec3){0, r->base, 0}, (sure_vec3){0, r->end, 0}, r->radius);
        sure_hit hit = {-1, 0, 0, 0};
        sure_status status = is_cone ? of_sure_cone_wall_hit_exact(&r->ray, &of, &hit)
                                     : of_sure_cylinder_wall_hit_exact(&r->ray, &of, &hit);
        ck_assert_int_eq(status, r->t == -1 ? SURE_MISS : SURE_HIT);
        ck_double_same(hit.t, r->t);
        ck_assert_int_eq(hit.leaves, r->leaves);
        if (status == SURE_HIT)
            ck_assert_int_eq(hit.part, SURE_PART_WALL);
        if (status == SURE_HIT && r->t == r->ray.t_min)
            ck_double_same(hit.t_error, 0);
    }
}

/* A cone's other nappe has the same wall, a cylinder turned round or moved along its axis. */
LOOP_TEST(test_law_1, PART_TIERS)
{
    static const sure_vec3 axes[] = {{0, 2, 0}, {1, 0, -1}, {2, 2, 0}, {0, 0, 1}};
    const sure_vec3 origin = {0, 0, 0};
    int found = 0;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 n = axes[is_cone ? 0 : i % 4];
        double r = 1 + suite_integer(7, i, 1);
        const sure_object plain = made(n, origin, r);
        const sure_object other =
            is_cone ? made((sure_vec3){-n.x, -n.y, -n.z}, origin, r) : made(origin, n, r);
        const sure_object moved = is_cone ? other
                                          : made((sure_vec3){3 * n.x, 3 * n.y, 3 * n.z},
                                                 (sure_vec3){5 * n.x, 5 * n.y, 5 * n.z}, r);
        const sure_ray ray = {
            suite_integers(1, i, 3),
            {suite_integer(4, i, 2), suite_integer(5, i, 2), 1 + abs(suite_integer(6, i, 1))},
            0,
            INFINITY};
        double t = first(_i, &ray, &plain);
        ck_double_same(first(_i, &ray, &other), t);
        ck_double_same(first(_i, &ray, &moved), t);
        found += t >= 0;
    }
    ck_assert_int_gt(found, 400);
}

LOOP_TEST(test_cylinder_normal, PART_TIERS)
{
    typedef sure_vec3 wall_normal(sure_vec3, const sure_cylinder *);
    static wall_normal *const normals[PART_TIERS] = {sure_cylinder_wall_normal_float32,
                                                     sure_cylinder_wall_normal_textbook};
    static const sure_cylinder around_y = {{0, 0, 0}, {0, 2, 0}, 2};
    ck_vector_same(normals[_i]((sure_vec3){0, 8, -2}, &around_y), (sure_vec3){0, 0, -1});
    ck_vector_same(normals[_i]((sure_vec3){2, -8, 0}, &around_y), (sure_vec3){1, 0, 0});
    ck_vector_same(normals[_i]((sure_vec3){0, -8, 0}, &around_y), (sure_vec3){0, 0, 0});
    if (_i != SURE_TIER_FLOAT32)
        ck_vector_same(normals[_i]((sure_vec3){3, 1, 4}, &around_y), (sure_vec3){0.6, 0, 0.8});
}

LOOP_TEST(test_invalid, PART_TIERS)
{
    const sure_ray still = {{0, 0, 0}, {0, 0, 0}, 0, INFINITY};
    const sure_ray ray = {{-5, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const sure_object flat = made((sure_vec3){1, 2, 3}, (sure_vec3){1, 2, 3}, 1);
    const sure_object upright = made((sure_vec3){0, 0, 0}, (sure_vec3){0, 2, 0}, 2);
    sure_hit hit;
    ck_assert_int_eq(hits[SUBJECT][_i](&still, &upright, &hit), SURE_INVALID);
    ck_assert_int_eq(hits[SUBJECT][_i](&ray, &flat, &hit), SURE_INVALID);
}

SUITE("wall")
