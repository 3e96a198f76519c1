/* SPDX-License-Identifier: MIT */
#include "camera_laws.h"
#include "small_scene.h"
#include "suite.h"

static const sure_camera camera = {.focal_length = 2, .viewport_width = 16, .viewport_height = 8};

/* Of one row or column, of an odd number, and of a huge one, where the eye is elsewhere. */
LOOP_TEST(test_laws, PLAIN_TIERS)
{
    static const int sizes[][2] = {{1, 1}, {8, 4}, {1279, 719}, {2147483647, 1}};
    pixel p = {.camera = camera};
    p.camera.position = (sure_vec3){0.3, -0.7, 0.1};
    for (int size = 0; size < 4; size++) {
        p.width = sizes[size][0];
        p.height = sizes[size][1];
        for (int i = 0; i < 27 * 27; i++) { /* from corner to corner, the middle among them */
            p.column = (int)((int64_t)(p.width - 1) * (i % 27) / 26);
            p.row = (int)((int64_t)(p.height - 1) * (i / 27) / 26);
            const char *broken = pixel_law_broken((sure_tier)_i, &p);
            ck_assert_msg(!broken, "%s: (%d, %d) of %d x %d", broken, p.column, p.row, p.width,
                          p.height);
        }
    }
}

/* Of a scene: from the eye itself, and turned back it is the camera's. */
TEST(test_in_the_world)
{
    static const sure_vec3 ahead[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                      {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    sure_scene scene = {.camera = camera, .width = 9, .height = 5};
    scene.camera.position = (sure_vec3){3, -5, 0.1};
    for (int i = 0; i < 500; i++) {
        sure_vec3 view =
            i < 6 ? ahead[i]
                  : (sure_vec3){suite_single(5, (uint64_t)i, 3), suite_single(6, (uint64_t)i, 3),
                                suite_single(7, (uint64_t)i, 3)};
        ck_assert_int_eq(sure_camera_rotation_textbook(view, &scene.turn), SURE_HIT);
        sure_ray middle = sure_scene_pixel_ray(&scene, 4, 2);
        if (i < 6)
            ck_vector_same(middle.direction, times(2, view));
        for (int k = 0; k < 45; k++) {
            sure_ray there = sure_scene_pixel_ray(&scene, k % 9, k / 9);
            sure_vec3 seen = sure_pixel_ray_textbook(&camera, 9, 5, k % 9, k / 9).direction;
            sure_vec3 back = sure_rotation_apply_textbook(&scene.turn, there.direction);
            sure_vec3 off = minus(back, seen);
            ck_vector_same(there.origin, scene.camera.position);
            ck_assert(dot(off, off) <= 0x1p-98 * dot(seen, seen));
        }
    }
}

SUITE("pixel_ray")
