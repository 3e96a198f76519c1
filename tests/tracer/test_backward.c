/* SPDX-License-Identifier: MIT */
#include "suite.h"
#include "small_scene.h"

#include <signal.h>

static const sure_material red = {.color = {1, 0, 0}}, blue = {.color = {0, 0, 1}};

/* What the one pixel shows. */
#define ck_seen(scene, ...)                                                                        \
    ck_vector_same(sure_backward_pixel(&(scene), (sure_tier)_i, 0, 0), (sure_vec3)__VA_ARGS__)

/* Steps 1 and 3: the nearest object's own colour, whatever the order of the list; of two at one
 * distance the lower index. */
LOOP_TEST(test_nearest, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, -9, 1), sphere(0, 0, -5, 1), sphere(0, 0, 5, 1)};
    sure_object tying[] = {sphere(0, 0, -5, 1), sphere(0, 0, -6, 2), sphere(0, 0, -5, 1)};
    sure_material materials[] = {blue, red, blue};
    sure_scene scene = looking(objects, materials, 3, NULL, 0);
    sure_ray ray = {{0, 0, 0}, {0, 0, -2}, 0, INFINITY},
             ahead = {{0, 0, 0}, {0, 0, -1}, 0, INFINITY};
    sure_nearest nearest = {.object = 77};
    scene.ambient = (sure_vec3){0.5, 0.5, 0.5};
    ck_seen(scene, {0.5, 0, 0});
    ck_assert_int_eq(sure_backward_nearest(&scene, (sure_tier)_i, &ray, NULL, &nearest), SURE_HIT);
    ck_assert_uint_eq(nearest.object, 1);
    ck_double_same(nearest.hit.t, 2);
    ray.direction.z = 0;
    ray.direction.x = 1;
    nearest.object = 77;
    ck_assert_int_eq(sure_backward_nearest(&scene, (sure_tier)_i, &ray, NULL, &nearest), SURE_MISS);
    ck_assert_uint_eq(nearest.object, 77);
    scene.objects = tying;
    ck_assert_int_eq(sure_backward_nearest(&scene, (sure_tier)_i, &ahead, NULL, &nearest),
                     SURE_HIT);
    ck_assert_uint_eq(nearest.object, 0);
}

/* Step 4: cos 4/5 from a lamp off to the side, shadow when something stands between. */
LOOP_TEST(test_light, SURE_TIERS)
{
    sure_object objects[] = {plane(0, 0, -4, 0, 0, 1), sphere(1.5, 0, -2, 0.5)};
    sure_material materials[] = {{.color = {1, 0.5, 0}}, blue};
    sure_light light = {{3, 0, 0}, {1, 1, 1}, 0.5};
    sure_scene scene = looking(objects, materials, 1, &light, 1);
    ck_seen(scene, {0.4, 0.2, 0});
    scene.object_count = 2;
    ck_seen(scene, {0, 0, 0});
    light.position.z = -8; /* behind the plane */
    scene.object_count = 1;
    ck_seen(scene, {0, 0, 0});
}

enum { LAMP_SIZE = 24 };

/* How many pixels that see the part have a highlight, out of how many. */
static int lit_of(const sure_object *floor, sure_part part, sure_vec3 lamp, sure_tier tier, int *of)
{
    const sure_material shiny = {.specular = 1, .shine = 0}; /* black but for the highlight */
    const sure_light light = {lamp, {1, 1, 1}, 1};
    sure_scene scene = looking(floor, &shiny, 1, &light, 1);
    int lit = *of = 0;
    scene.width = scene.height = LAMP_SIZE;
    for (int row = 0; row < LAMP_SIZE; row++) {
        int column[LAMP_SIZE], rows[LAMP_SIZE];
        sure_vec3 seen[LAMP_SIZE];
        for (int i = 0; i < LAMP_SIZE; i++) {
            column[i] = i;
            rows[i] = row;
        }
        sure_backward_pixels(&scene, tier, LAMP_SIZE, column, rows, seen);
        for (int i = 0; i < LAMP_SIZE; i++) {
            const sure_ray ray = sure_scene_pixel_ray(&scene, i, row);
            sure_nearest nearest;
            if (sure_backward_nearest(&scene, tier, &ray, NULL, &nearest) != SURE_HIT ||
                nearest.hit.part != part)
                continue;
            lit += seen[i].x > 0;
            *of += 1;
        }
    }
    return lit;
}

/* A lamp in a flat part's own plane gives nothing, not even a highlight, wherever the points that
 * are seen are rounded to; the least above it gives the highlight that one well above gives. */
TEST(test_lamp_in_the_plane)
{
    const sure_vec3 foot = {-1, -8, -7}, head = {0, -1, -4};
    const sure_vec3 level = {0.25, -0.3, -7.75}, slanting = {7, -2, -4};
    const struct {
        sure_object floor;
        sure_part part;
        sure_vec3 lamp;
    } of[] = {
        {plane(0, -0.3, 0, 0, 1, 0), SURE_PART_SURFACE, level},
        {plane(0, -0.3, 0, 0, -1, 0), SURE_PART_SURFACE, level},
        {plane(0, -1, -4, 1, 7, 3), SURE_PART_SURFACE, slanting},
        {{SURE_SHAPE_DISC, {.disc = {head, {1, 7, 3}, 3}}}, SURE_PART_SURFACE, slanting},
        {{SURE_SHAPE_CYLINDER, {.cylinder = {foot, head, 3}}}, SURE_PART_TOP, slanting},
        {{SURE_SHAPE_CONE, {.cone = {head, foot, 3}}}, SURE_PART_BASE, slanting},
        {{SURE_SHAPE_BOX, {.box = {{-2, -5, -9}, {2, -0.3, -1}}}}, SURE_PART_Y_MAX, level},
        {{SURE_SHAPE_BOX, {.box = {{-9, -0.3, -9}, {9, 9, 9}}}}, SURE_PART_Y_MIN, level},
    };
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
            sure_vec3 above = of[k].lamp, below = above, high = above;
            int seen;
            above.y = nextafter(above.y, 1);
            below.y = nextafter(below.y, -9);
            high.y += 0x1p-30;
            ck_assert_int_eq(lit_of(&of[k].floor, of[k].part, of[k].lamp, tier, &seen), 0);
            ck_assert_int_eq(lit_of(&of[k].floor, of[k].part, below, tier, &seen), 0);
            int lit = lit_of(&of[k].floor, of[k].part, above, tier, &seen);
            ck_assert_int_eq(lit, lit_of(&of[k].floor, of[k].part, high, tier, &seen));
            ck_assert(LAMP_SIZE < lit && lit <= seen);
        }
    }
}

/* The lamps add up. */
LOOP_TEST(test_two_lights, SURE_TIERS)
{
    sure_object wall = plane(0, 0, -4, 0, 0, 1);
    sure_light lights[] = {{{0, 0, 0}, {1, 1, 1}, 0.25}, {{3, 0, 0}, {0, 1, 0}, 0.5}};
    sure_scene scene = looking(&wall, &(sure_material){.color = {1, 1, 1}}, 1, lights, 2);
    scene.ambient = (sure_vec3){0.125, 0, 0};
    ck_seen(scene, {0.375, 0.25 + 0.4, 0.25});
}

/* The eye inside a solid sees its inner wall, lit by a lamp inside and not by one outside. */
LOOP_TEST(test_inside, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, 0, 4)};
    sure_light light = {{0, 0, 0}, {1, 1, 1}, 1};
    sure_scene scene = looking(objects, &red, 1, &light, 1);
    ck_seen(scene, {1, 0, 0});
    light.position.z = 9;
    ck_seen(scene, {0, 0, 0});
}

/* Law 3: the eye on a plane that it looks along or down on, on a sphere looking out, on a cap. */
LOOP_TEST(test_law_3, SURE_TIERS)
{
    sure_object objects[] = {plane(0, 0, 0, 0, 3, 1),
                             {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 1}, 1}}},
                             {SURE_SHAPE_CYLINDER, {.cylinder = {{0, 0, 2}, {0, 0, 0}, 1}}},
                             {SURE_SHAPE_CONE, {.cone = {{0, 0, 1}, {0, 0, 0}, 1}}},
                             sphere(0, 0, -5, 1)};
    sure_material materials[] = {blue, blue, blue, blue, red};
    sure_scene scene = looking(objects, materials, 5, NULL, 0);
    scene.ambient = (sure_vec3){1, 1, 1};
    ck_seen(scene, {1, 0, 0});
}

/* A mirror shows what lies behind the eye, itself not; its depth ends. */
LOOP_TEST(test_mirror, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, -5, 1), sphere(0, 0, 5, 1)};
    sure_material materials[] = {{.color = {1, 0, 0}, .mirror = 0.5}, blue};
    sure_scene scene = looking(objects, materials, 2, NULL, 0);
    scene.ambient = (sure_vec3){1, 1, 1};
    ck_seen(scene, {0.5, 0, 0.5});
    for (scene.depth = -1; scene.depth <= 0; scene.depth++)
        ck_seen(scene, {1, 0, 0});
    materials[1] = materials[0];
    scene.depth = 3; /* red three times, halved each time, and what the last mirror has by itself */
    ck_seen(scene, {1, 0, 0});
    const sure_vec3 ahead = {0, 0, -1}, back = {0, 0, 1};
    double fresnel = sure_refract_fresnel_textbook(ahead, back, 1 / 1.5);
    fresnel = 2 * fresnel / (1 + fresnel);
    /* A pane: of what its mirror leaves Fresnel's share is reflected, too. */
    objects[0] = plane(0, 0, -4, 0, 0, 1);
    materials[0] = (sure_material){.mirror = 0.5, .refract = 1.5};
    materials[1] = blue;
    ck_seen(scene, {0, 0, 0.5 + 0.5 * fresnel});
}

/* The inside of a mirror, a ball or a tube: the ray leaves it and meets it on the far side. */
LOOP_TEST(test_mirror_inside, 2 * SURE_TIERS)
{
    const sure_tier tier = (sure_tier)(_i % SURE_TIERS);
    const bool is_tube = _i >= SURE_TIERS;
    const sure_object tube = {SURE_SHAPE_CYLINDER, {.cylinder = {{0, 0, -4}, {0, 0, 4}, 4}}};
    sure_object objects[] = {is_tube ? tube : sphere(0, 0, 0, 4)};
    sure_scene scene = looking(objects, &red, 1, NULL, 0);
    sure_surface_point wall = {.object = 0, .point = {0, 0, -4}, .normal = {0, 0, 1}, .inside = 1};
    sure_ray back = {{0, 0, -4}, {0, 0, 2}, 0, INFINITY};
    sure_nearest nearest;
    if (tier == SURE_TIER_CERTAIN || tier == SURE_TIER_EXACT) /* from where sure_spawn would */
        back.origin.z = wall.point.z = -4 + 0x1p-51;
    ck_assert_int_eq(sure_backward_nearest(&scene, tier, &back, &wall, &nearest), SURE_HIT);
    ck_double_same(nearest.hit.t, (4 - wall.point.z) / 2);
    ck_assert_int_eq(nearest.hit.part, is_tube ? SURE_PART_TOP : SURE_PART_SURFACE);
    ck_assert_int_eq(nearest.hit.leaves, 1);
    wall.inside = 0;
    ck_assert_int_eq(sure_backward_nearest(&scene, tier, &back, &wall, &nearest), SURE_MISS);
}

/* Straight through the middle of a glass ball to a wall of white: what comes through both surfaces,
 * and what is reflected within, there and back, till the depth ends. */
LOOP_TEST(test_glass, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, -5, 1), plane(0, 0, -9, 0, 0, 1)};
    sure_material materials[] = {{.color = {1, 0.5, 1}, .refract = 1.5}, {.color = {1, 1, 1}}};
    sure_scene scene = looking(objects, materials, 2, NULL, 0);
    const sure_vec3 ahead = {0, 0, -1}, back = {0, 0, 1};
    double in = sure_refract_fresnel_textbook(ahead, back, 1 / 1.5);
    double out = sure_refract_fresnel_textbook(ahead, back, 1.5);
    double far, near, green, first, green_first;
    scene.ambient = (sure_vec3){1, 1, 1};
    scene.depth = 2;
    far = out * 1 + (1 - out) * 1; /* the reflection, seen no further, shows its ambient colour */
    green = out * 0.5 + (1 - out) * (0.5 * 1);
    first = (1 - in) * far;
    green_first = (1 - in) * (0.5 * green);
    ck_seen(scene, {first, green_first, first});
    scene.depth = 3;
    near = out * 1; /* behind the eye there is nothing */
    far = out * near + (1 - out) * 1;
    green = out * (out * 0.5) + (1 - out) * (0.5 * 1);
    first = (1 - in) * far;
    green_first = (1 - in) * (0.5 * green);
    ck_seen(scene, {first, green_first, first});
}

/* The camera's lengths are of no account, up to the limits: beside the middle of the ball, which is
 * a mirror, too. */
LOOP_TEST(test_scales_of_the_camera, SURE_TIERS)
{
    static const int scales[] = {0, -400, 400};
    sure_object objects[] = {sphere(0.25, 0.125, -5, 1), plane(0, 0, -9, 0, 0.25, 1)};
    const sure_material glass = {.color = {1, 0.5, 1}, .mirror = 0.25, .refract = 1.5};
    sure_material materials[] = {glass, {.color = {1, 1, 1}}};
    sure_light light = {{3, 4, 5}, {1, 1, 1}, 1};
    sure_scene scene = looking(objects, materials, 2, &light, 1);
    sure_vec3 plain = {0, 0, 0};
    for (int i = 0; i < (_i == SURE_TIER_FLOAT32 ? 1 : 3); i++) {
        double by = ldexp(1, scales[i]);
        scene.camera = (sure_camera){{0, 0, 0}, by, by, by};
        sure_vec3 seen = sure_backward_pixel(&scene, (sure_tier)_i, 0, 0);
        plain = i == 0 ? seen : plain;
        ck_vector_same(seen, plain);
    }
    ck_assert(plain.x > 0);
}

SIGNAL_TEST(test_too_large_a_window, SIGABRT)
{
    const sure_object ball = sphere(0, 0, -5, 1);
    sure_scene scene = looking(&ball, &red, 1, NULL, 0);
    scene.camera.viewport_width = 0x1.1p400;
    (void)sure_backward_pixel(&scene, SURE_TIER_CERTAIN, 0, 0);
}

/* An index of 1 leaves what is behind as it is, whatever the shape. */
LOOP_TEST(test_clear_as_air, SURE_TIERS)
{
    sure_object wall = plane(0, 0, -9, 0, 1, 1);
    sure_object objects[] = {wall,
                             sphere(0.5, 0.25, -5, 1.5),
                             plane(0, 0, -2, 0.5, 0, 1),
                             {SURE_SHAPE_CYLINDER, {.cylinder = {{1, 1, -4}, {-1, -0.5, -3}, 0.5}}},
                             {SURE_SHAPE_CONE, {.cone = {{1, 0, -3}, {-1, 0.5, -2.5}, 0.75}}}};
    const sure_material clear = {.color = {1, 1, 1}, .refract = 1};
    sure_material materials[] = {{.color = {1, 0.5, 0.25}}, clear, clear, clear, clear};
    sure_scene scene = looking(objects, materials, 5, NULL, 0);
    scene.ambient = (sure_vec3){1, 1, 1};
    scene.width = scene.height = 16;
    scene.depth = 16;
    for (int i = 0; i < 256; i++)
        ck_vector_same(sure_backward_pixel(&scene, (sure_tier)_i, i % 16, i / 16),
                       materials[0].color);
}

/* A ray within glass beyond the critical angle stays in it, to the end of the depth. */
LOOP_TEST(test_total_reflection, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, 0, 4)};
    const sure_material glass = {.color = {1, 1, 1}, .refract = 4};
    sure_statistics statistics = {0};
    sure_scene scene = looking(objects, &glass, 1, NULL, 0);
    scene.camera.position = (sure_vec3){3.75, 0, 0};
    scene.depth = 5;
    (void)sure_backward_pixel_told(&scene, (sure_tier)_i, 0, 0, &statistics);
    ck_assert_uint_eq(statistics.rays[SURE_RAY_MIRROR], 5);
    ck_assert_uint_eq(statistics.rays[SURE_RAY_REFRACTED], 0);
}

/* Law 1: whatever was asked before. Steps 2 and 4 with a highlight and the inverse square law on
 * the way: the eye straight above, the light at distance 4 behind it. */
LOOP_TEST(test_law_1, SURE_TIERS)
{
    sure_object wall = plane(0, 0, -4, 0, 0, 1);
    sure_material shiny = {.color = {0.5, 0.25, 0}, .specular = 0.5, .shine = 8};
    sure_light light = {{0, 0, 0}, {1, 1, 1}, 64};
    sure_scene scene = looking(&wall, &shiny, 1, &light, 1);
    sure_vec3 plain = sure_backward_pixel(&scene, (sure_tier)_i, 0, 0);
    ck_vector_same(plain, (sure_vec3){64, 48, 32});
    scene.falloff = SURE_FALLOFF_INVERSE_SQUARE;
    double share = 64 / (4 * pi * 16);
    ck_seen(scene, {share, share * 0.75, share * 0.5});
    scene.falloff = SURE_FALLOFF_NONE;
    ck_vector_same(sure_backward_pixel(&scene, (sure_tier)_i, 0, 0), plain);
    shiny.refract = 1.5; /* what is clear has the highlight alone */
    ck_seen(scene, {32, 32, 32});
}

/* A rim that is touched from outside is seen from outside, though the cap's normal points away: a
 * lamp within the solid does not reach it. */
LOOP_TEST(test_rim_from_outside, SURE_TIERS)
{
    sure_object solid = {SURE_SHAPE_CYLINDER, {.cylinder = {{0, -1, -3}, {0, 1, -3}, 1}}};
    sure_light light = {{0, 0, -3}, {1, 1, 1}, 1};
    sure_scene scene = looking(&solid, &red, 1, &light, 1);
    scene.camera.viewport_height = 2;
    scene.height = 2; /* the lower pixel looks along (0, -1/2, -1) and meets (0, -1, -2) */
    ck_seen(scene, {0, 0, 0});
}

LOOP_TEST(test_law_2, SURE_TIERS)
{
    sure_object objects[] = {sphere(0, 0, -5, 1), sphere(0.5, 0.25, -4, 0.75)};
    sure_material materials[] = {blue, red};
    sure_light light = {{2, 3, 0}, {1, 1, 1}, 1};
    sure_scene scene = looking(objects, materials, 2, &light, 1), turned;
    sure_object objects_turned[] = {objects[1], objects[0]};
    sure_material materials_turned[] = {red, blue};
    scene.width = scene.height = 16;
    turned = scene;
    turned.objects = objects_turned;
    turned.materials = materials_turned;
    int seen = 0;
    for (int i = 0; i < 16; i++) {
        for (int j = 0; j < 16; j++) {
            sure_vec3 color = sure_backward_pixel(&scene, (sure_tier)_i, i, j);
            ck_vector_same(sure_backward_pixel(&turned, (sure_tier)_i, i, j), color);
            seen += color.x > 0 && color.z == 0;
        }
    }
    ck_assert_int_gt(seen, 4);
}

/* A point of a plane that is farther than doubles reach, from the eye or from the light, has its
 * ambient light alone. */
LOOP_TEST(test_beyond_doubles, SURE_TIERS)
{
    const sure_object floor = plane(0, 0, -1e308, 0, 0, 1);
    const sure_light light = {{0, 0, 0}, {1, 1, 1}, 1};
    sure_scene scene = looking(&floor, &red, 1, &light, 1);
    scene.ambient = (sure_vec3){0.5, 0.5, 0.5};
    scene.camera.viewport_width = 1000;
    scene.width = 2;
    sure_vec3 seen = sure_backward_pixel(&scene, (sure_tier)_i, 1, 0);
    ck_assert(seen.x == 0.5 || (_i == SURE_TIER_FLOAT32 && seen.x == 0));
    const sure_material shiny = {.color = {1, 0, 0}, .specular = 1};
    const sure_light behind = {{0, 0, 1e308}, {1, 1, 1}, 1};
    scene.materials = &shiny;
    scene.lights = &behind;
    scene.width = 1;
    seen = sure_backward_pixel(&scene, (sure_tier)_i, 0, 0);
    ck_assert(seen.x == 0.5 || (_i == SURE_TIER_FLOAT32 && seen.x == 0));
}

/* A ray that ends where it leaves the solid meets it there; one double before it doesn't. */
TEST(test_leaves_at_its_end)
{
    const sure_object ball = sphere(0, 0, 0, 1);
    const sure_material matte = {.color = {1, 1, 1}};
    const sure_scene scene = looking(&ball, &matte, 1, NULL, 0);
    const sure_surface_point inside = {0, {0, 0, 0}, {-1, 0, 0}, 1};
    for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
        sure_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, 1};
        sure_hit hit;
        ck_assert_int_eq(sure_scene_meets_again(&scene, tier, &ray, &inside, &hit), SURE_HIT);
        ck_double_same(hit.t, 1);
        ray.t_max = nextafter(1, 0);
        ck_assert_int_eq(sure_scene_meets_again(&scene, tier, &ray, &inside, &hit), SURE_MISS);
        ray.t_max = 0.25;
        ck_assert_int_eq(sure_scene_meets_again(&scene, tier, &ray, &inside, &hit), SURE_MISS);
        ray.t_max = INFINITY;
        ck_assert_int_eq(sure_scene_meets_again(&scene, tier, &ray, &inside, &hit), SURE_HIT);
        ck_assert_int_eq(hit.leaves, 1);
    }
}

/* A disc that the ray has gone past, to end below it, covers nothing; and no ray starts inside of a
 * ball of radius 0. */
TEST(test_starts)
{
    const sure_object passed[] = {plane(0, 0, -4, 0, 0, 1),
                                  {SURE_SHAPE_DISC, {.disc = {{1, 0, -3}, {1, 0, 1}, 0.5}}}};
    const sure_object point = sphere(0, 0, -4, 0);
    const sure_material materials[] = {red, blue}, glass = {.refract = 1.5};
    const sure_light light = {{0, 0, 0}, {1, 1, 1}, 1};
    sure_scene scene = looking(passed, materials, 2, &light, 1);
    sure_statistics beside = {0}, without = {0};
    (void)sure_backward_pixel_told(&scene, SURE_TIER_CERTAIN, 0, 0, &beside);
    ck_assert(beside.origins == 1 && beside.covered == 0);
    scene = looking(&point, &glass, 1, NULL, 0);
    (void)sure_backward_pixel_told(&scene, SURE_TIER_CERTAIN, 0, 0, &without);
    ck_assert(without.origins == 1 && without.without_origin == 1);
}

/* The last pixel is that of what is added, all else a sum. No kind is beyond the last. */
TEST(test_statistics_add)
{
    const sure_statistics more = {.seen = SURE_HIT,
                                  .nearest = {.object = 3},
                                  .acne = 2,
                                  .stage = SURE_STAGE_EXACT,
                                  .rays = {1, 0, 0, 7}};
    sure_statistics sum = more;
    sum.seen = SURE_MISS;
    sum.stage = SURE_STAGE_DOUBLE;
    sum.nearest.object = 1;
    sure_statistics_add(&sum, &more);
    ck_assert(sum.seen == SURE_HIT && sum.nearest.object == 3 && sum.stage == SURE_STAGE_EXACT);
    ck_assert_ptr_null(sure_ray_kind_name((sure_ray_kind)SURE_RAY_KINDS));
    ck_assert(sum.rays[0] == 2 && sum.rays[3] == 14 && sum.acne == 4 && sum.missed == 0);
}

SUITE("backward")
