/* Pictures by their hashes, for what `surehit regress` does not keep as golden pictures: the tiers
 * that nobody draws with, a crowd, and builds without libpng. tests/golden/SCENES has a line a
 * picture: scene, tier, size, hash of its bytes. A picture of another hash is left in the build
 * folder, to be looked at; `test_scenes CROWD.rt --accept` renews the hashes. */
#include "render_file.h"
#include "suite.h"

#include <inttypes.h>
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

/* How many; none, with a message, when the list cannot be read to its end. */
static int read_list(void)
{
    FILE *file = fopen(suite_file("golden/SCENES"), "r");
    golden g;
    int fields = 0;
    while (file && listed < MOST &&
           (fields = fscanf(file, "%63s %15s %dx%d %" SCNx64, g.scene, g.tier, &g.width, &g.height,
                            &g.hash)) == 5)
        list[listed++] = g;
    if (!file || fields != EOF || listed == 0) {
        fprintf(stderr, "golden/SCENES: cannot be read behind line %d\n", listed);
        listed = 0;
    }
    if (file)
        fclose(file);
    return listed;
}

static const char *scene_path(const golden *g)
{
    return strcmp(g->scene, "crowd") == 0 ? crowd : suite_file("scenes/%s.rt", g->scene);
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
    render_settings settings = render_defaults();
    settings.reading_set = RT_SET(RT_SIZE);
    settings.reading.width = g->width;
    settings.reading.height = g->height;
    return sure_tier_from_name(g->tier, &settings.how.tier) &&
           render_file(scene_path(g), &settings, stderr, image);
}

LOOP_TEST(test_golden, read_list())
{
    const golden *g = &list[_i];
    picture got;
    ck_assert(rendered(g, &got));
    if (hash_of(&got) != g->hash) {
        char path[128];
        snprintf(path, sizeof path, "got-%s-%s.ppm", g->scene, g->tier);
        ck_assert(picture_write(&got, path, stderr));
        ck_abort_msg("%s, tier %s: another picture; see %s in the build folder's tests, and hold "
                     "it against an older build's with `surehit diff`; `ninja accept-hashes` "
                     "renews the hashes",
                     g->scene, g->tier, path);
    }
    picture_free(&got);
}

static int accept_all(void)
{
    for (int i = 0; i < listed; i++) {
        picture image;
        if (!rendered(&list[i], &image))
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
    if (listed == 0)
        return EXIT_FAILURE;
    if (argc > 2 && strcmp(argv[2], "--accept") == 0)
        return accept_all();
    return suite_main("scenes", NULL, NULL);
}
