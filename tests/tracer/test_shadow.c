#include "suite.h"
#include "objects.h"

#include <math.h>

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
    ck_assert(reaches(_i, objects, 2, beside, (sure_vec3){9, 9, 0}));
    ck_assert(!reaches(_i, objects, 2, under, (sure_vec3){0, 5, 0})); /* within it */
    ck_assert(!reaches(_i, objects, 2, (sure_surface_point){.object = 0, .point = {1, 0, 0}},
                       (sure_vec3){1, 9, 0})); /* tangent: touched is obstructed */
}

/* A light on an object's surface still shines. */
LOOP_TEST(test_light_on_surface, SURE_TIERS)
{
    sure_object objects[] = {ground, sphere(0, 5, 0, 1)};
    sure_surface_point under = {.object = 0, .point = {0, 0, 0}, .normal = up};
    ck_assert(reaches(_i, objects, 2, under, (sure_vec3){0, 4, 0}));
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

/* Law 1, and law 2 with the surface point only nearly on the surface, as rounding leaves it. */
LOOP_TEST(test_laws, SURE_TIERS)
{
    int lit = 0, shaded = 0;
    for (uint64_t i = 0; i < 3000; i++) {
        sure_vec3 c = {suite_double(1, i, 1), suite_double(2, i, 1), suite_double(3, i, 1)};
        sure_vec3 n = {suite_double(4, i, 0), suite_double(5, i, 0), suite_double(6, i, 0)};
        double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z), r = 1;
        n = (sure_vec3){n.x / length, n.y / length, n.z / length};
        sure_surface_point p = {.object = 0, .normal = n};
        p.point = (sure_vec3){c.x + r * n.x, c.y + r * n.y, c.z + r * n.z};
        sure_vec3 light = {p.point.x + 3 * n.x + suite_double(7, i, 0),
                           p.point.y + 3 * n.y + suite_double(8, i, 0),
                           p.point.z + 3 * n.z + suite_double(9, i, 0)};
        sure_object objects[] = {
            sphere(c.x, c.y, c.z, r),
            sphere(suite_double(10, i, 2), suite_double(11, i, 2), suite_double(12, i, 2), 1)};
        ck_assert(reaches(_i, objects, 1, p, light));
        sure_object more[] = {
            objects[0], objects[1],
            sphere(suite_double(13, i, 2), suite_double(14, i, 2), suite_double(15, i, 2), 1)};
        ck_assert(reaches(_i, objects, 2, p, light) || !reaches(_i, more, 3, p, light));
        if (reaches(_i, objects, 2, p, light))
            lit++;
        else
            shaded++;
    }
    ck_assert_int_gt(lit, 100);
    ck_assert_int_gt(shaded, 100);
}

SUITE("shadow")
