#include "report.h"

#include "../scene/placement.h"
#include "../scene/rt_notes.h"
#include "../support/base64.h"
#include "../support/cpu_time.h"
#include "../support/folder.h"
#include "../support/median.h"
#include "../support/progress.h"

#include <stdlib.h>
#include <string.h>

/* page.html says what they show. */
static const struct {
    const char *name, *file;
} subjects[] = {
    {"ball", "A 0.15 255,255,255\n"
             "C 0,0,30000000 0,0,-1 4.125e-6\n"
             "L 18000000,21000000,27000000 0.85\n"
             "sp 0,0,0 2 206,92,70\n"
             "R 160 160\n"},
    {"cylinder and cone", "A 0.15 255,255,255\n"
                          "C 0,0,10000000 0,0,-1 2.177e-5\n"
                          "L 6000000,7000000,9000000 0.85\n"
                          "cy -0.85,0,0 0.3,1,0.35 1.1 2.2 80,140,210\n"
                          "co 0.9,0,0 -0.3,1,0.3 1.5 2.3 120,180,90\n"
                          "R 160 160\n"},
};

/* NULL: no memory. */
static json_t *draw_tier(const sure_scene *scene, sure_tier tier)
{
    const render_options how = {.tier = tier};
    picture image;
    if (!picture_new(scene->width, scene->height, &image))
        return NULL;
    render(scene, &how, &image);
    char *text = base64_of(image.rgb, 3 * (size_t)image.width * (size_t)image.height);
    json_t *drawn = text ? json_string(text) : NULL;
    free(text);
    picture_free(&image);
    return drawn;
}

static json_t *draw_tiers(const sure_scene *scene)
{
    json_t *drawn = json_object();
    for (int tier = 0; tier < SURE_TIERS; tier++)
        json_object_set_new(drawn, sure_tier_name((sure_tier)tier),
                            draw_tier(scene, (sure_tier)tier));
    return drawn;
}

static json_t *draw_subject(const char *name, const char *text)
{
    rt_options reading = rt_default_options();
    rt_options_set set = 0;
    rt_scene file;
    sure_scene scene;
    if (!rt_read_text(text, strlen(text), "the report's scene", &reading, set, stderr, &file))
        return NULL;
    bool placed = placement(&file, stderr, &scene);
    rt_scene_free(&file);
    if (!placed)
        return NULL;
    json_t *drawn = json_pack("{s:s, s:s, s:i, s:i, s:o}", "name", name, "file", text, "width",
                              scene.width, "height", scene.height, "tiers", draw_tiers(&scene));
    placement_free(&scene);
    return drawn;
}

json_t *report_pictures_draw(void)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sizeof subjects / sizeof *subjects; i++) {
        if (json_array_append_new(list, draw_subject(subjects[i].name, subjects[i].file)) == 0)
            continue;
        report_fail("a picture cannot be drawn");
        json_decref(list);
        return NULL;
    }
    return list;
}

/* A folder of scenes. */

/* Small, so that a folder of dozens takes seconds; and even: the ray of a pixel in the very middle
 * is a case of its own, in scenes laid out along the axes. */
enum { WIDTH = 80, HEIGHT = 50, PIXELS = WIDTH * HEIGHT, ROUNDS = 3 };

#define SCENE ".rt"

/* It counts once it is there. */
static bool read_scene(const char *folder, const char *file, trade *of)
{
    render_settings settings = RENDER_DEFAULTS;
    settings.reading.width = WIDTH;
    settings.reading.height = HEIGHT;
    settings.reading_set = RT_SET(RT_SIZE);
    struct trade_scene *one = &of->scenes[of->count];
    char *path = folder_path(folder, file, strlen(file), "");
    one->name = rt_printable_name(file);
    bool done = (path && one->name) || report_fail("no memory");
    done = done && render_file_place(path, &settings, stderr, &one->placed);
    free(path);
    if (!done) {
        free(one->name);
        return false;
    }
    one->name[strlen(one->name) - strlen(SCENE)] = '\0';
    of->count++;
    return true;
}

bool report_trade_read(const char *folder, trade *of)
{
    folder_listing found;
    *of = (trade){NULL, 0};
    bool done = folder_list(folder, "", SCENE, stderr, &found);
    if (done && found.count == 0)
        fprintf(stderr, "%s: error: no scene in it (*" SCENE ")\n", folder);
    done = done && found.count > 0;
    if (done && !(of->scenes = calloc((size_t)found.count, sizeof *of->scenes)))
        done = report_fail("no memory");
    for (int i = 0; done && i < found.count; i++)
        done = read_scene(folder, found.names[i], of);
    folder_free(&found);
    return done;
}

void report_trade_free(trade *of)
{
    for (int i = 0; i < of->count; i++) {
        free(of->scenes[i].name);
        placement_free(&of->scenes[i].placed.scene);
    }
    free(of->scenes);
    *of = (trade){NULL, 0};
}

/* By this thread alone, whose time is taken. Without photons: beside them nothing else would be
 * seen in the time of so small a picture, and they change no pixel's object. */
static void draw(const sure_scene *scene, sure_tier tier, pixel_record *records, picture *on)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1, .records = records},
                                      .integrator = INTEGRATOR_BACKWARD};
    render_scene(scene, &settings, on);
}

/* Does the pixel show the same object, or none in both? */
static bool shows_same(const pixel_record *a, const pixel_record *b)
{
    bool hit = a->seen == SURE_HIT;
    return hit == (b->seen == SURE_HIT) && (!hit || a->object == b->object);
}

static json_t *count_wrong(const sure_scene *scene, picture *on)
{
    static pixel_record right[PIXELS], seen[PIXELS];
    json_t *counts = json_array();
    draw(scene, SURE_TIER_EXACT, right, on);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        int wrong = 0;
        draw(scene, (sure_tier)tier, seen, on);
        for (int i = 0; i < PIXELS; i++)
            wrong += !shows_same(&seen[i], &right[i]);
        json_array_append_new(counts, json_integer(wrong));
    }
    return counts;
}

/* Without records, which take time themselves; the tiers in turn. */
static json_t *take_times(const sure_scene *scene, picture *on)
{
    json_t *times = json_array();
    double nanoseconds[SURE_TIERS][ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        for (int tier = 0; tier < SURE_TIERS; tier++) {
            double started = cpu_time();
            draw(scene, (sure_tier)tier, NULL, on);
            nanoseconds[tier][round] = cpu_time() - started;
        }
    }
    for (int tier = 0; tier < SURE_TIERS; tier++)
        json_array_append_new(times, json_real(median_of(nanoseconds[tier], ROUNDS) / PIXELS));
    return times;
}

static json_t *draw_all(const trade *of, picture *on, bool shown)
{
    json_t *rows = json_array();
    progress bar = progress_start(shown ? stderr : NULL, of->count);
    for (int i = 0; i < of->count; i++) {
        const sure_scene *scene = &of->scenes[i].placed.scene;
        json_t *wrong = count_wrong(scene, on);
        json_array_append_new(rows, json_pack("{s:s, s:o, s:o}", "name", of->scenes[i].name,
                                              "wrong_pixels", wrong, "nanoseconds_a_pixel",
                                              take_times(scene, on)));
        progress_step(&bar, 1);
    }
    progress_finish(&bar);
    return rows;
}

static json_t *tier_names(void)
{
    json_t *names = json_array();
    for (int tier = 0; tier < SURE_TIERS; tier++)
        json_array_append_new(names, json_string(sure_tier_name((sure_tier)tier)));
    return names;
}

json_t *report_trade_draw(const trade *of, bool shown)
{
    picture on = {.rgb = NULL};
    json_t *found = NULL;
    if (picture_new(WIDTH, HEIGHT, &on))
        found = json_pack("{s:i, s:i, s:i, s:o, s:o}", "width", WIDTH, "height", HEIGHT, "rounds",
                          ROUNDS, "tiers", tier_names(), "rows", draw_all(of, &on, shown));
    if (!found)
        report_fail("no memory");
    picture_free(&on);
    return found;
}
