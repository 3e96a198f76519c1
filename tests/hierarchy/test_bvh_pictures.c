/* Whole pictures with the hierarchy and without: the same colours, in tiers that are sure. What the
 * others may lose is printed. Of all our scenes and a crowd. */
#include "bvh_build.h"
#include "placement.h"
#include "scene_text.h"
#include "suite.h"

#include <string.h>

enum { WIDTH = 64, HEIGHT = 36 };

static int differences(const sure_scene *without, const sure_scene *with, sure_tier tier)
{
    int different = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        sure_vec3 a = sure_backward_pixel(without, tier, i % WIDTH, i / WIDTH);
        sure_vec3 b = sure_backward_pixel(with, tier, i % WIDTH, i / WIDTH);
        different += memcmp(&a, &b, sizeof a) != 0;
    }
    return different;
}

LOOP_TEST(test_pictures, (int)scene_files(true)->gl_pathc + 1)
{
    const glob_t *files = scene_files(true);
    const char *path = (size_t)_i < files->gl_pathc ? files->gl_pathv[_i] : CROWD;
    rt_scene file = scene_of_size(path, WIDTH, HEIGHT);
    sure_scene scene = scene_placed(&file), with = scene;
    sure_bvh bvh;
    ck_assert(bvh_build(scene.objects, scene.object_count, 2, &bvh));
    with.bvh = &bvh;
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        int different = differences(&scene, &with, (sure_tier)tier);
        printf("%s, %s: %d of %d pixels differ\n", path, sure_tier_name((sure_tier)tier), different,
               WIDTH * HEIGHT);
        if (tier >= SURE_TIER_CERTAIN)
            ck_assert_int_eq(different, 0);
    }
    bvh_free(&bvh);
    placement_free(&scene);
    rt_scene_free(&file);
}

SUITE("bvh pictures")
