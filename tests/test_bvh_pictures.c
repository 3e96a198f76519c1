/* Whole pictures with the hierarchy and without: the same colours, in tiers that are sure. What the
 * others may lose is printed. Arguments: further scenes. */
#include "bvh_build.h"
#include "placement.h"
#include "suite.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 36 };

static const char *const own[] = {"default", "edge_on", "falloff", "far",           "ground_1e8",
                                  "inside",  "left",    "mirrors", "needles_coins", "wild"};
enum { OWN = sizeof own / sizeof *own };

static const char *const *further;
static int further_count;

static const char *path_of(int scene)
{
    return scene < OWN ? suite_file("scenes/%s.rt", own[scene]) : further[scene - OWN];
}

static void read_scene(int number, sure_scene *scene)
{
    rt_options reading = rt_default_options();
    rt_options_set set = {.size = true};
    rt_scene file;
    reading.width = WIDTH;
    reading.height = HEIGHT;
    ck_assert(rt_read(path_of(number), &reading, &set, stderr, &file));
    ck_assert(placement(&file, stderr, scene));
    rt_scene_free(&file);
}

static bool same_color(sure_vec3 a, sure_vec3 b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Pixels that differ; *lit counts those that are not black. */
static int differences(const sure_scene *without, const sure_scene *with, sure_tier tier, int *lit)
{
    const sure_vec3 black = {0, 0, 0};
    int different = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        sure_vec3 a = sure_backward_pixel(without, tier, i % WIDTH, i / WIDTH);
        sure_vec3 b = sure_backward_pixel(with, tier, i % WIDTH, i / WIDTH);
        different += !same_color(a, b);
        *lit += !same_color(a, black);
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
        int lit = 0, different = differences(&scene, &with, (sure_tier)tier, &lit);
        printf("%s, %s: %d of %d pixels differ\n", path_of(_i), sure_tier_name((sure_tier)tier),
               different, WIDTH * HEIGHT);
        ck_assert_int_gt(lit, 0);
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
    further = (const char *const *)argv + 1;
    further_count = argc - 1;
    tcase_set_timeout(tests, 300);
    tcase_add_loop_test(tests, test_pictures, 0, OWN + further_count);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
