/* SPDX-License-Identifier: MIT */
/* A box with equal coordinates is drawn as the sheet it is. */
#include "../../src/hierarchy/bvh_build.h"
#include "suite.h"
#include "small_scene.h"

#include <surehit/backward.h>
#include <surehit/mixed.h>

#include <math.h>

enum { SIZE = 8, PIXELS = SIZE * SIZE };

static const sure_material materials_of[] = {
    {.color = {1, 0.5, 0.25}},
    {.color = {1, 0.5, 0.25}, .specular = 0.5, .shine = 4},
    {.color = {1, 0.5, 0.25}, .mirror = 0.75},
    {.color = {1, 0.5, 0.25}, .mirror = 1},
    {.color = {1, 0.5, 0.25}, .refract = 1.5},
    {.color = {1, 0.5, 0.25}, .refract = 1, .mirror = 0.25, .specular = 0.5, .shine = 4},
};
enum { MATERIALS = sizeof materials_of / sizeof *materials_of };

static sure_object box(sure_vec3 low, sure_vec3 high)
{
    return (sure_object){SURE_SHAPE_BOX, {.box = {low, high}}};
}

/* `along` in the axis's coordinate, `across` in the others. */
static sure_vec3 along_axis(int axis, double along, double across)
{
    return (sure_vec3){axis == 0 ? along : across, axis == 1 ? along : across,
                       axis == 2 ? along : across};
}

/* From the side of the axis that `side` is the sign of, straight at the sheet. */
static void face(sure_scene *scene, int axis, int side)
{
    sure_vec3 back = along_axis(axis, side, 0), right = along_axis((axis + 1) % 3, 1, 0);
    scene->turn = (sure_mat3){{right, cross(back, right), back}};
    scene->camera.position = times(5, back);
    scene->width = scene->height = SIZE;
}

/* Packets see what rays see alone. */
static void see(const sure_scene *scene, sure_tier tier, sure_vec3 seen[PIXELS])
{
    int column[PIXELS], row[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        column[i] = i % SIZE;
        row[i] = i / SIZE;
    }
    sure_backward_pixels(scene, tier, PIXELS, column, row, seen);
    for (int i = 0; i < PIXELS; i++)
        ck_vector_same(seen[i], sure_backward_pixel(scene, tier, column[i], row[i]));
}

/* From both sides of each axis, of each material, a lamp on either side: as a disc, whose t is the
 * same, since no number of either is rounded. */
LOOP_TEST(test_as_disc, SURE_TIERS)
{
    const sure_tier tier = (sure_tier)_i;
    for (int i = 0; i < 3 * 2 * 2 * MATERIALS; i++) {
        const int axis = i % 3, side = i / 3 % 2 ? 1 : -1, lit = i / 6 % 2 ? 1 : -1;
        const sure_vec3 n = along_axis(axis, 1, 0);
        const sure_object ahead = sphere(-8 * n.x, -8 * n.y, -8 * n.z, 2),
                          behind = sphere(8 * n.x, 8 * n.y, 8 * n.z, 2);
        const sure_object sheets[2][3] = {
            {box(along_axis(axis, 0, -64), along_axis(axis, 0, 64)), ahead, behind},
            {{SURE_SHAPE_DISC, {.disc = {{0, 0, 0}, n, 64}}}, ahead, behind}};
        const sure_material materials[] = {
            materials_of[i / 12], {.color = {0, 1, 0}}, {.color = {0, 0, 1}}};
        const sure_light light = {along_axis(axis, 3 * lit, 2), {1, 1, 1}, 1};
        sure_vec3 seen[2][PIXELS];
        for (int k = 0; k < 2; k++) {
            sure_scene scene = looking(sheets[k], materials, 3, &light, 1);
            scene.ambient = (sure_vec3){0.125, 0.125, 0.125};
            face(&scene, axis, side);
            see(&scene, tier, seen[k]);
        }
        for (int k = 0; k < PIXELS; k++)
            ck_vector_same(seen[0][k], seen[1][k]);
        if (i / 12 == 0)
            ck_assert(side == lit ? seen[0][0].x > 0.25 : seen[0][0].x == 0.125);
    }
}

/* Mirrored in x the picture is flipped, edges and corners included. */
LOOP_TEST(test_flipped, SURE_TIERS)
{
    for (int i = 0; i < 3 * MATERIALS; i++) {
        sure_vec3 low = {-1.5, -1, -6}, high = {0.5, 0.75, -4};
        *coordinate_of(&low, i % 3) = *coordinate_of(&high, i % 3) = i % 3 == 2 ? -4 : 0.5;
        const sure_object sheets[2] = {box(low, high), box((sure_vec3){-high.x, low.y, low.z},
                                                           (sure_vec3){-low.x, high.y, high.z})};
        const sure_light light = {{2, 3, 0}, {1, 1, 1}, 1}, other = {{-2, 3, 0}, {1, 1, 1}, 1};
        sure_vec3 seen[2][PIXELS];
        for (int k = 0; k < 2; k++) {
            sure_scene scene = looking(&sheets[k], &materials_of[i / 3], 1, k ? &other : &light, 1);
            scene.width = scene.height = SIZE;
            see(&scene, (sure_tier)_i, seen[k]);
        }
        for (int k = 0; k < PIXELS; k++)
            ck_vector_same(seen[0][k], seen[1][k / SIZE * SIZE + SIZE - 1 - k % SIZE]);
    }
}

/* Rays leave it on the side asked for, and find nothing in between. */
TEST(test_starts)
{
    const sure_object sheet = box((sure_vec3){-64, -64, 0.1}, (sure_vec3){64, 64, 0.1});
    for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
        for (int side = -1; side <= 1; side += 2) {
            sure_statistics told = {0};
            sure_scene scene = looking(&sheet, &materials_of[4], 1, NULL, 0);
            face(&scene, 2, side);
            for (int i = 0; i < PIXELS; i++)
                (void)sure_backward_pixel_told(&scene, tier, i % SIZE, i / SIZE, &told);
            ck_assert_uint_eq(told.rays[SURE_RAY_REFRACTED], PIXELS);
            ck_assert_uint_eq(told.rays[SURE_RAY_MIRROR], PIXELS);
            ck_assert_uint_eq(told.missed, 2 * PIXELS);
            ck_assert_uint_eq(told.origins, 2 * PIXELS);
            ck_assert_uint_eq(told.without_origin + told.acne + told.covered, 0);
        }
    }
}

/* What goes through glass on it passes it unseen: that is counted, as of a disc, a plane and a
 * solid, with a hierarchy and without. */
TEST(test_covered)
{
    const sure_vec3 low = {-64, -64, 0.1}, high = {64, 64, 0.1}, n = {0, 0, 1};
    const sure_object flat = plane(0, 0, 0.1, 0, 0, 1), sheet = box(low, high),
                      solid = box((sure_vec3){-64, -64, -64}, high),
                      disc = {SURE_SHAPE_DISC, {.disc = {{0, 0, 0.1}, n, 64}}};
    const sure_object pairs[4][2] = {{flat, sheet}, {flat, disc}, {disc, flat}, {disc, solid}};
    const sure_material materials[] = {materials_of[4], materials_of[0]};
    for (int i = 0; i < 4 * 2 * 2; i++) {
        sure_statistics told = {0};
        sure_scene scene = looking(pairs[i % 4], materials, 2, NULL, 0);
        sure_bvh bvh = {0};
        ck_assert(bvh_build(scene.objects, 2, 1, &bvh));
        scene.bvh = i < 8 ? &bvh : NULL;
        face(&scene, 2, i / 4 % 2 ? -1 : 1);
        for (int k = 0; k < PIXELS; k++)
            (void)sure_backward_pixel_told(&scene, SURE_TIER_CERTAIN, k % SIZE, k / SIZE, &told);
        ck_assert_uint_eq(told.origins, 2 * PIXELS);
        ck_assert_uint_eq(told.covered, PIXELS);
        bvh_free(&bvh);
    }
}

/* On an edge, too, its face is seen; a segment across the ray and a point are as small sheets. */
LOOP_TEST(test_edges, SURE_TIERS)
{
    const sure_object ends[] = {box((sure_vec3){0, -1, -4}, (sure_vec3){1, 1, -4}),
                                box((sure_vec3){0, 0, -4}, (sure_vec3){1, 1, -4}),
                                box((sure_vec3){-1, 0, -4}, (sure_vec3){0, 0, -4}),
                                box((sure_vec3){0, 0, -4}, (sure_vec3){0, 0, -4})};
    const sure_light light = {{0, 0, 0}, {1, 1, 1}, 1};
    for (int i = 0; i < 4; i++) {
        const sure_scene scene = looking(&ends[i], &materials_of[0], 1, &light, 1);
        ck_vector_same(sure_backward_pixel(&scene, (sure_tier)_i, 0, 0), materials_of[0].color);
    }
}

/* Along it, from beside it and from within it, whatever it is made of. */
LOOP_TEST(test_along, SURE_TIERS)
{
    const sure_object along[] = {box((sure_vec3){-1, 0, -4}, (sure_vec3){1, 0, -3}),
                                 box((sure_vec3){0, 0, -4}, (sure_vec3){0, 0, -3}),
                                 box((sure_vec3){-1, 0, -4}, (sure_vec3){1, 0, 3}),
                                 box((sure_vec3){0, 0, -4}, (sure_vec3){0, 0, 0}),
                                 box((sure_vec3){0, 0, 0}, (sure_vec3){0, 0, 0})};
    const sure_light light = {{0, 1, 0}, {1, 1, 1}, 1};
    for (int i = 0; i < 5 * MATERIALS; i++) {
        const sure_scene scene = looking(&along[i % 5], &materials_of[i / 5], 1, &light, 1);
        const sure_vec3 seen = sure_backward_pixel(&scene, (sure_tier)_i, 0, 0);
        ck_assert(isfinite(seen.x + seen.y + seen.z));
    }
}

/* What a mirror sends to it lands on the face that it comes to. */
LOOP_TEST(test_photons, SURE_TIERS)
{
    for (int side = -1; side <= 1; side += 2) {
        const sure_object objects[] = {box((sure_vec3){-64, -64, 0}, (sure_vec3){64, 64, 0}),
                                       plane(0, 0, 8 * side, 0, 0, 1)};
        const sure_material materials[] = {materials_of[0], materials_of[3]};
        const sure_light light = {{0, 0, 4 * side}, {1, 1, 1}, 1};
        const sure_scene scene = looking(objects, materials, 2, &light, 1);
        const sure_mixed_cell cell = {
            .axis = 2, .octant = side < 0 ? 4 : 0, .row = 0, .column = 0, .cells = 4};
        sure_photon landed;
        ck_assert_int_eq(sure_mixed_photon(&scene, (sure_tier)_i, &cell, 1, 0, 1, &landed), 1);
        ck_assert_int_eq(landed.face.part, side < 0 ? SURE_PART_Z_MIN : SURE_PART_Z_MAX);
        ck_assert_int_eq(landed.face.side, SURE_SIDE_OUTSIDE);
    }
}

SUITE("flat_box")
