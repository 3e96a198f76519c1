/* SPDX-License-Identifier: MIT */
#include "suite.h"
#include "objects.h"

static const sure_object ground = {SURE_SHAPE_PLANE, {.plane = {{0, 0, 0}, {0, 1, 0}}}};
static const sure_vec3 up = {0, 1, 0};

static int reaches(int tier, const sure_object *objects, size_t count, sure_surface_point from,
                   sure_vec3 light)
{
    sure_scene scene = {.objects = objects, .object_count = count};
    return sure_shadow_reaches(&scene, (sure_tier)tier, &from, light);
}

LOOP_TEST(test_known, SURE_TIERS)
{
    sure_object objects[] = {ground, sphere(0, 5, 0, 1)};
    sure_surface_point under = {.object = 0, .point = {0, 0, 0}, .normal = up};
    sure_surface_point beside = {.object = 0, .point = {9, 0, 0}, .normal = up};
    ck_assert(!reaches(_i, objects, 2, under, (sure_vec3){0, 9, 0}));
    ck_assert(reaches(_i, objects, 2, under, (sure_vec3){0, 3, 0})); /* before the sphere */
    ck_assert(reaches(_i, objects, 2, under, (sure_vec3){0, 4, 0})); /* on it: it still shines */
    ck_assert(reaches(_i, objects, 2, beside, (sure_vec3){9, 9, 0}));
    ck_assert(!reaches(_i, objects, 2, under, (sure_vec3){0, 5, 0})); /* within it */
    ck_assert(!reaches(_i, objects, 2, (sure_surface_point){.object = 0, .point = {1, 0, 0}},
                       (sure_vec3){1, 9, 0})); /* tangent: touched is obstructed */
}

LOOP_TEST(test_inside, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, 0, 2)};
    sure_surface_point wall = {.object = 0, .point = {2, 0, 0}, .normal = {-1, 0, 0}, .inside = 1};
    if (_i == SURE_TIER_CERTAIN || _i == SURE_TIER_EXACT) /* where sure_spawn is */
        wall.point.x = 2 - 0x1p-52;
    ck_assert(reaches(_i, objects, 1, wall, (sure_vec3){0, 0, 0}));
    ck_assert(reaches(_i, objects, 1, wall, (sure_vec3){-1, 1, 0}));
    ck_assert(!reaches(_i, objects, 1, wall, (sure_vec3){-4, 0, 0}));
}

static sure_object ball(sure_vec3 centre)
{
    return sphere(centre.x, centre.y, centre.z, 1);
}

/* Law 1, and law 2 with the surface point only nearly on the surface, as rounding leaves it. */
LOOP_TEST(test_laws, SURE_TIERS)
{
    int lit = 0, shaded = 0;
    for (uint64_t i = 0; i < 3000; i++) {
        sure_vec3 c = suite_doubles(1, i, 1), n = suite_doubles(4, i, 0);
        n = times(1 / sqrt(dot(n, n)), n);
        sure_surface_point p = {.object = 0, .point = plus(c, n), .normal = n};
        sure_vec3 light = plus(plus(p.point, times(3, n)), suite_doubles(7, i, 0));
        sure_object objects[] = {ball(c), ball(suite_doubles(10, i, 2)),
                                 ball(suite_doubles(13, i, 2))};
        ck_assert(reaches(_i, objects, 1, p, light));
        ck_assert(reaches(_i, objects, 2, p, light) || !reaches(_i, objects, 3, p, light));
        if (reaches(_i, objects, 2, p, light))
            lit++;
        else
            shaded++;
    }
    ck_assert_int_gt(lit, 100);
    ck_assert_int_gt(shaded, 100);
}

/* A light on a curved surface, or on a plane across no axis: it lights what is before the surface's
 * tangent plane there and, of a solid, nothing behind; from within it lights all. The way's rounded
 * direction leads past it. */
TEST(test_light_on_surface)
{
    const sure_vec3 apex = {0, 0, 5}, none = {0, 0, 0};
    const struct {
        sure_object object;
        sure_vec3 light, outward;
        bool solid;
    } of[] = {
        {sphere(-1, 0, 2, 1.5), {-0.5, 1, 1}, {1, 2, -2}, true},
        {{SURE_SHAPE_CYLINDER, {.cylinder = {none, apex, 5}}}, {3, 4, 1.25}, {3, 4, 0}, true},
        {{SURE_SHAPE_CONE, {.cone = {none, apex, 5}}}, {1.5, 2, 2.5}, {3, 4, 5}, true},
        {{SURE_SHAPE_PLANE, {.plane = {{0, -1, -4}, {1, 7, 3}}}}, {7, -2, -4}, none, false},
        {{SURE_SHAPE_DISC, {.disc = {{0, -1, -4}, {1, 7, 3}, 9}}}, {7, -2, -4}, none, false},
    };
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        const sure_object objects[] = {of[k].object, ground};
        int lit = 0, shaded = 0;
        for (int i = 0; i < 2 * 2000; i++) {
            const sure_tier tier = i % 2 ? SURE_TIER_EXACT : SURE_TIER_CERTAIN;
            const uint64_t draw = (uint64_t)i / 2;
            const sure_vec3 way = suite_doubles(1, draw, 0);
            const sure_vec3 far = times(12 / sqrt(dot(way, way)), way);
            const sure_surface_point from = {.object = 1, .point = far};
            const sure_vec3 back = plus(far, times(-1, of[k].light));
            const bool before = !of[k].solid || dot(of[k].outward, back) > 0;
            ck_assert_int_eq(reaches(tier, objects, 2, from, of[k].light), before);
            lit += before;
            shaded += !before;
        }
        ck_assert(lit > 1000 && (!of[k].solid || shaded > 1000));
    }
}

/* What is seen from within by a light on the wall. */
TEST(test_light_on_wall)
{
    const sure_vec3 foot = {0, 0, 0}, head = {0, 0, 5};
    const sure_object objects[] = {sphere(0, 0, 0, 5),
                                   {SURE_SHAPE_CYLINDER, {.cylinder = {foot, head, 5}}},
                                   {SURE_SHAPE_CONE, {.cone = {foot, head, 5}}}};
    const sure_vec3 lights[] = {{0, 3, 4}, {3, 4, 1.25}, {1.5, 2, 2.5}};
    for (int i = 0; i < 2 * 3 * 2000; i++) {
        const sure_tier tier = i % 2 ? SURE_TIER_EXACT : SURE_TIER_CERTAIN;
        const int k = i / 2 % 3;
        const sure_vec3 off = suite_doubles(1, (uint64_t)i / 6, 0);
        const sure_surface_point from = {
            .object = 0, .point = {off.x, off.y, 1.5 + off.z}, .inside = 1};
        ck_assert(reaches(tier, &objects[k], 1, from, lights[k]));
    }
    /* This one is just within the ball, whose wall the way's rounded direction meets before. */
    const sure_vec3 within = {-0x1.58f9e15520cddp+1, 0x1.df6ac3baf2eb8p+1, 0x1.ecf4184a25f37p+0};
    const sure_vec3 at = {-0x1.1bc932c766cc6p-1, 0x1.28297bc124f01p+1, 0x1.18b8a99a9ee67p+2};
    const sure_surface_point beside = {.object = 0, .point = at, .inside = 1};
    ck_assert(reaches(SURE_TIER_CERTAIN, objects, 1, beside, within));
    ck_assert(reaches(SURE_TIER_EXACT, objects, 1, beside, within));
}

SUITE("shadow")
