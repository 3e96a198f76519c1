#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "report.h"

#include "../support/cpu_time.h"
#include "../support/folder.h"
#include "../support/median.h"
#include "../support/progress.h"
#include "../scene/rt_notes.h"

#include <stdlib.h>
#include <string.h>

/* Small, so that a folder of dozens takes seconds; and even: the ray of a pixel in the very middle
 * is a case of its own, in scenes laid out along the axes. */
enum { WIDTH = 80, HEIGHT = 50, PIXELS = WIDTH * HEIGHT, ROUNDS = 3 };

#define SCENE ".rt"

/* Reading. */

/* It counts once it is there. */
static bool read_scene(const char *folder, const char *file, trade *of)
{
    render_settings settings = render_defaults();
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
    if (done)
        of->scenes = calloc((size_t)found.count, sizeof *of->scenes);
    if (done && !of->scenes)
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
        placed_scene_free(&of->scenes[i].placed);
    }
    free(of->scenes);
    *of = (trade){NULL, 0};
}

/* Drawing. */

typedef struct {
    picture image;
    pixel_record *right, *seen;
} sheet;

/* By this thread alone, whose time is taken. Without photons: beside them nothing else would be
 * seen in the time of so small a picture, and they change no pixel's object. */
static void draw(const sure_scene *scene, sure_tier tier, pixel_record *records, sheet *on)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1, .records = records},
                                      .integrator = INTEGRATOR_BACKWARD};
    render_scene(scene, &settings, &on->image);
}

/* Does the pixel show the same object, or none in both? */
static bool shows_same(const pixel_record *a, const pixel_record *b)
{
    bool hit = a->seen == SURE_HIT;
    return hit == (b->seen == SURE_HIT) && (!hit || a->object == b->object);
}

static json_t *count_wrong(const sure_scene *scene, sheet *on)
{
    json_t *counts = json_array();
    draw(scene, SURE_TIER_EXACT, on->right, on);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        int wrong = 0;
        draw(scene, (sure_tier)tier, on->seen, on);
        for (int i = 0; i < PIXELS; i++)
            wrong += !shows_same(&on->seen[i], &on->right[i]);
        json_array_append_new(counts, json_integer(wrong));
    }
    return counts;
}

/* Without records, which take time themselves; the tiers in turn. */
static json_t *take_times(const sure_scene *scene, sheet *on)
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

static json_t *draw_all(const trade *of, sheet *on, bool shown)
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
    sheet on = {.right = calloc(PIXELS, sizeof *on.right), .seen = calloc(PIXELS, sizeof *on.seen)};
    json_t *found = NULL;
    if (picture_new(WIDTH, HEIGHT, &on.image) && on.right && on.seen)
        found = json_pack("{s:i, s:i, s:i, s:o, s:o}", "width", WIDTH, "height", HEIGHT, "rounds",
                          ROUNDS, "tiers", tier_names(), "rows", draw_all(of, &on, shown));
    if (!found)
        report_fail("no memory");
    picture_free(&on.image);
    free(on.right);
    free(on.seen);
    return found;
}
