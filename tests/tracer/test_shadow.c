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

SUITE("shadow")
