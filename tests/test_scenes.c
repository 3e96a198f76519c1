/* Golden pictures. tests/golden/SCENES has a line a picture: scene, tier, size, hash of its bytes;
 * the picture itself is tests/golden/<scene>-<tier>.png. `test_scenes CROWD.rt --accept` renews
 * hashes and pictures, which are to be looked at before they are committed. */
#include "picture.h"
#include "placement.h"
#include "render.h"
#include "suite.h"

#include <inttypes.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    char scene[64], tier[16];
    int width, height;
    uint64_t hash;
} golden;

enum { MOST = 64 };
static golden list[MOST];
static int listed;
static const char *crowd; /* the scene that make_crowd.py made */

/* False, with a message, when the list cannot be read to its end. */
static bool read_list(void)
{
    FILE *file = fopen(suite_file("golden/SCENES"), "r");
    golden g;
    int fields = 0;
    while (file && listed < MOST &&
           (fields = fscanf(file, "%63s %15s %dx%d %" SCNx64, g.scene, g.tier, &g.width, &g.height,
                            &g.hash)) == 5)
        list[listed++] = g;
    if (!file || fields != EOF)
        fprintf(stderr, "golden/SCENES: cannot be read behind line %d\n", listed);
    return file && fclose(file) == 0 && fields == EOF;
}

static const char *scene_path(const golden *g)
{
    return strcmp(g->scene, "crowd") == 0 ? crowd : suite_file("scenes/%s.rt", g->scene);
}

static const char *picture_path(const golden *g)
{
    return suite_file("golden/%s-%s.png", g->scene, g->tier);
}

/* FNV-1a, 64 bits. */
static uint64_t hash_of(const picture *image)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < 3 * (size_t)image->width * (size_t)image->height; i++)
        hash = (hash ^ image->rgb[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static bool rendered(const golden *g, picture *image)
{
    rt_options options = rt_default_options();
    rt_options_set set = {.size = true};
    rt_scene file;
    sure_scene scene;
    render_options how = {0};
    options.width = g->width;
    options.height = g->height;
    bool read = sure_tier_from_name(g->tier, &how.tier) &&
                rt_read(scene_path(g), &options, &set, stderr, &file);
    bool placed = read && placement(&file, stderr, &scene);
    bool made = placed && picture_new(g->width, g->height, image);
    if (made)
        render(&scene, &how, image);
    if (placed)
        placement_free(&scene);
    if (read)
        rt_scene_free(&file);
    return made;
}

static picture read_png(const char *path)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    picture image;
    ck_assert_msg(png_image_begin_read_from_file(&png, path) != 0, "%s: %s", path, png.message);
    png.format = PNG_FORMAT_RGB;
    ck_assert(picture_new((int)png.width, (int)png.height, &image));
    ck_assert(png_image_finish_read(&png, NULL, image.rgb, 0, NULL) != 0);
    return image;
}

/* Pixels that differ, written white on the darkened golden picture. */
static size_t difference(const picture *expected, const picture *got, const char *path)
{
    picture shown;
    size_t count = 0;
    ck_assert(picture_new(got->width, got->height, &shown));
    for (size_t i = 0; i < (size_t)got->width * (size_t)got->height; i++) {
        int differs = memcmp(expected->rgb + 3 * i, got->rgb + 3 * i, 3) != 0;
        for (int c = 0; c < 3; c++)
            shown.rgb[3 * i + (size_t)c] =
                differs ? 255 : (uint8_t)(expected->rgb[3 * i + (size_t)c] / 3);
        count += (size_t)differs;
    }
    ck_assert(picture_write(&shown, path, stderr));
    picture_free(&shown);
    return count;
}

START_TEST(test_golden)
{
    const golden *g = &list[_i];
    picture got;
    ck_assert(rendered(g, &got));
    if (hash_of(&got) != g->hash) {
        picture expected = read_png(picture_path(g));
        ck_assert_msg(expected.width == got.width && expected.height == got.height,
                      "%s: the golden picture is %dx%d", g->scene, expected.width, expected.height);
        char path[128];
        snprintf(path, sizeof path, "difference-%s-%s.png", g->scene, g->tier);
        ck_abort_msg("%s, tier %s: %zu of %d pixels differ, see %s in the build folder's tests; "
                     "`ninja accept-scenes` renews the golden picture",
                     g->scene, g->tier, difference(&expected, &got, path), got.width * got.height,
                     path);
    }
    picture_free(&got);
}
END_TEST

/* The pictures beside the list are those that were hashed. */
START_TEST(test_pictures_are_the_hashed_ones)
{
    picture image = read_png(picture_path(&list[_i]));
    ck_assert_msg(hash_of(&image) == list[_i].hash, "%s", picture_path(&list[_i]));
    picture_free(&image);
}
END_TEST

static int accept_all(void)
{
    for (int i = 0; i < listed; i++) {
        picture image;
        if (!rendered(&list[i], &image) ||
            !picture_write(&image, picture_path(&list[i]), stderr))
            return EXIT_FAILURE;
        list[i].hash = hash_of(&image);
        picture_free(&image);
    }
    FILE *file = fopen(suite_file("golden/SCENES"), "w");
    for (int i = 0; file && i < listed; i++)
        fprintf(file, "%s %s %dx%d %016" PRIx64 "\n", list[i].scene, list[i].tier, list[i].width,
                list[i].height, list[i].hash);
    return file && fclose(file) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    crowd = argc > 1 ? argv[1] : "";
    if (!read_list())
        return EXIT_FAILURE;
    if (argc > 2 && strcmp(argv[2], "--accept") == 0)
        return accept_all();
    Suite *suite = suite_create("scenes");
    TCase *tests = tcase_create("scenes");
    tcase_set_timeout(tests, 300);
    tcase_add_loop_test(tests, test_golden, 0, listed);
    tcase_add_loop_test(tests, test_pictures_are_the_hashed_ones, 0, listed);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
