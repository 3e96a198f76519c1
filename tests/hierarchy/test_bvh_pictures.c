/* Whole pictures with the hierarchy and without: the same colours, in tiers that are sure. What the
 * others may lose is printed. Of all our scenes; arguments: further ones. */
#define _POSIX_C_SOURCE 200809L /* glob */

#include "bvh_build.h"
#include "placement.h"
#include "suite.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 36 };

static glob_t scenes;

/* All paths: ours, then those of the command line. */
static void find_scenes(int count, char **further)
{
    glob(suite_file("scenes/*.rt"), 0, NULL, &scenes);
    glob(suite_file("scenes/extreme/*.rt"), GLOB_APPEND, NULL, &scenes);
    for (int i = 0; i < count; i++)
        glob(further[i], GLOB_APPEND | GLOB_NOCHECK, NULL, &scenes);
}

static void read_scene(int number, sure_scene *scene)
{
    rt_options reading = rt_default_options();
    rt_options_set set = RT_SET(RT_SIZE);
    rt_scene file;
    reading.width = WIDTH;
    reading.height = HEIGHT;
    ck_assert(rt_read(scenes.gl_pathv[number], &reading, set, stderr, &file));
    ck_assert(placement(&file, stderr, scene));
    rt_scene_free(&file);
}

static bool same_color(sure_vec3 a, sure_vec3 b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static int differences(const sure_scene *without, const sure_scene *with, sure_tier tier)
{
    int different = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        sure_vec3 a = sure_backward_pixel(without, tier, i % WIDTH, i / WIDTH);
        sure_vec3 b = sure_backward_pixel(with, tier, i % WIDTH, i / WIDTH);
        different += !same_color(a, b);
    }
    return different;
}

START_TEST(test_pictures)
{
    sure_scene scene, with;
    sure_bvh bvh;
    read_scene(_i, &scene);
    with = scene;
    ck_assert(bvh_build(scene.objects, scene.object_count, 2, &bvh));
    with.bvh = &bvh;
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        int different = differences(&scene, &with, (sure_tier)tier);
        printf("%s, %s: %d of %d pixels differ\n", scenes.gl_pathv[_i],
               sure_tier_name((sure_tier)tier), different, WIDTH * HEIGHT);
        if (tier >= SURE_TIER_CERTAIN)
            ck_assert_int_eq(different, 0);
    }
    bvh_free(&bvh);
    placement_free(&scene);
}
END_TEST

int main(int argc, char **argv)
{
    Suite *suite = suite_create("bvh pictures");
    TCase *tests = tcase_create("pictures");
    find_scenes(argc - 1, argv + 1);
    tcase_set_timeout(tests, 300);
    tcase_add_loop_test(tests, test_pictures, 0, (int)scenes.gl_pathc);
    suite_add_tcase(suite, tests);
    int status = suite_run(suite);
    globfree(&scenes);
    return status;
}
