/* SPDX-License-Identifier: MIT */
/* The extreme scenes by every tier: pixels of a wrong object, pixels of a wrong colour, time.
 *
 *   pictures --record FILE SCENES...    writes the record, docs/pictures.csv
 *   pictures --check FILE SCENES...     counts anew, but for the truth, and compares
 *   pictures --draw FOLDER SCENES...    a PNG a scene: each tier's picture, below it what is wrong
 *
 * SCENES is a pattern as of the shell. */
#include "../support/sights.h"

#include "median.h"
#include "progress.h"
#include "render_file.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, ROUNDS = 5 };

static const char head[] = "scene,tier,pixels,wrong,wrong_by_exact,wrong_color,microseconds\n";

/* What a tier makes of a scene. */
typedef struct {
    picture image;
    sights seen;
    int wrong, wrong_by_exact, wrong_color;
    double seconds[ROUNDS];
} view;

typedef struct {
    const char *name; /* the file's without folder and ending: name_length bytes of it */
    int name_length;
    placed_scene placed;
    view views[SURE_TIERS];
} subject;

static picture new_picture(int width, int height)
{
    picture image;
    if (!picture_new(width, height, &image))
        abort();
    return image;
}

static void draw(const subject *s, sure_tier tier, picture *image)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1},
                                      .integrator = INTEGRATOR_BACKWARD};
    render_scene(&s->placed.scene, &settings, image);
}

/* Colours that are the same but for their rounding to a byte are at most one level apart. */
static bool is_wrong_color(const uint8_t *rgb, const uint8_t *expected)
{
    return abs(rgb[0] - expected[0]) > 1 || abs(rgb[1] - expected[1]) > 1 ||
           abs(rgb[2] - expected[2]) > 1;
}

static void count(subject *s)
{
    const view *exact = &s->views[SURE_TIER_EXACT];
    for (int tier = SURE_TIERS - 1; tier >= 0; tier--) {
        view *v = &s->views[tier];
        *v = (view){.image = new_picture(WIDTH, HEIGHT),
                    .seen = sights_drawn(&s->placed.scene, (sure_tier)tier)};
        draw(s, (sure_tier)tier, &v->image);
        v->wrong_by_exact = sights_differ(&v->seen, &exact->seen);
        for (int i = 0; i < PIXELS; i++)
            v->wrong_color += is_wrong_color(v->image.rgb + 3 * i, exact->image.rgb + 3 * i);
    }
}

/* The tiers in turn. */
static void time_frames(subject *s)
{
    for (int i = 0; i < ROUNDS * SURE_TIERS; i++) {
        view *v = &s->views[i % SURE_TIERS];
        double started = progress_clock();
        draw(s, (sure_tier)(i % SURE_TIERS), &v->image);
        v->seconds[i / SURE_TIERS] = progress_clock() - started;
    }
}

/* All but the time. */
static const char *row_of(const subject *s, int tier)
{
    static char row[256];
    const view *v = &s->views[tier];
    snprintf(row, sizeof row, "%.*s,%s,%d,%d,%d,%d,", s->name_length, s->name,
             sure_tier_name((sure_tier)tier), PIXELS, v->wrong, v->wrong_by_exact, v->wrong_color);
    return row;
}

static bool record(subject *s, FILE *out, const char *path)
{
    (void)path;
    sights truth = sights_true(&s->placed.scene);
    time_frames(s);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        view *v = &s->views[tier];
        v->wrong = sights_differ(&v->seen, &truth);
        fprintf(out, "%s%.0f\n", row_of(s, tier), 1e6 * median_of(v->seconds, ROUNDS));
    }
    sights_free(&truth);
    return true;
}

/* The record's next lines against what is counted now; what the truth says is taken from there. */
static bool check(subject *s, FILE *in, const char *path)
{
    bool same = true;
    (void)path;
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        char line[256] = "";
        if (fgets(line, sizeof line, in))
            (void)sscanf(line, "%*[^,],%*[^,],%*d,%d", &s->views[tier].wrong);
        const char *row = row_of(s, tier);
        if (strncmp(line, row, strlen(row)) == 0)
            continue;
        printf("counted: %s\nthe record has: %s\n", row, line);
        same = false;
    }
    return same;
}

/* Two rows of four panels, a gap between. */
enum { COLUMNS = SURE_TIER_EXACT, GAP = 2, SHEET_WIDTH = COLUMNS * (WIDTH + GAP) - GAP };

/* Below: exact's picture, pale; red for another object, blue for another colour. */
static void mark(const subject *s, const view *v, int i, uint8_t rgb[3])
{
    static const uint8_t red[3] = {220, 0, 0}, blue[3] = {0, 80, 255};
    const view *exact = &s->views[SURE_TIER_EXACT];
    const uint8_t *expected = exact->image.rgb + 3 * i;
    for (int part = 0; part < 3; part++)
        rgb[part] = (uint8_t)(192 + expected[part] / 4);
    if (is_wrong_color(v->image.rgb + 3 * i, expected))
        memcpy(rgb, blue, 3);
    if (v->seen.objects[i] != exact->seen.objects[i])
        memcpy(rgb, red, 3);
}

static void fill_panel(const subject *s, int column, picture *sheet)
{
    const view *v = &s->views[column];
    for (int i = 0; i < PIXELS; i++) {
        int x = column * (WIDTH + GAP) + i % WIDTH, y = i / WIDTH;
        memcpy(sheet->rgb + 3 * (y * SHEET_WIDTH + x), v->image.rgb + 3 * i, 3);
        mark(s, v, i, sheet->rgb + 3 * ((y + HEIGHT + GAP) * SHEET_WIDTH + x));
    }
}

/* Nothing for a scene that every tier draws right. */
static bool draw_sheet(subject *s, FILE *unused, const char *folder)
{
    char path[4096];
    int wrong = 0;
    (void)unused;
    for (int tier = 0; tier < SURE_TIERS; tier++)
        wrong += s->views[tier].wrong_by_exact + s->views[tier].wrong_color;
    if (wrong == 0)
        return true;
    picture sheet = new_picture(SHEET_WIDTH, 2 * HEIGHT + GAP);
    memset(sheet.rgb, 255, 3 * (size_t)sheet.width * (size_t)sheet.height);
    for (int column = 0; column < COLUMNS; column++)
        fill_panel(s, column, &sheet);
    snprintf(path, sizeof path, "%s/%.*s.png", folder, s->name_length, s->name);
    bool written = picture_write(&sheet, path, stderr);
    picture_free(&sheet);
    return written;
}

static const struct {
    const char *word, *mode; /* of the record that is opened, if one is */
    bool (*of_scene)(subject *s, FILE *list, const char *target);
} tasks[] = {{"--record", "w", record}, {"--check", "r", check}, {"--draw", NULL, draw_sheet}};
enum { TASKS = sizeof tasks / sizeof *tasks };

static bool do_scene(const char *path, int what, FILE *list, const char *target)
{
    const render_settings settings = {.reading = {.width = WIDTH, .height = HEIGHT},
                                      .reading_set = RT_SET(RT_SIZE)};
    subject s = {.name = strrchr(path, '/') + 1};
    s.name_length = (int)strcspn(s.name, ".");
    if (!render_file_place(path, &settings, stderr, &s.placed))
        return false;
    count(&s);
    bool ok = tasks[what].of_scene(&s, list, target);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        picture_free(&s.views[tier].image);
        sights_free(&s.views[tier].seen);
    }
    placement_free(&s.placed.scene);
    return ok;
}

/* NULL where it can't be, or begins otherwise. */
static FILE *open_list(const char *path, const char *mode)
{
    char line[sizeof head] = "";
    FILE *list = fopen(path, mode);
    if (list && *mode == 'w')
        fputs(head, list);
    if (list && (*mode == 'w' || (fgets(line, sizeof line, list) && strcmp(line, head) == 0)))
        return list;
    fprintf(stderr, "%s: cannot be opened, or has another head than this program writes\n", path);
    return NULL;
}

int main(int count_of_words, char **words)
{
    glob_t paths = {.gl_pathc = 0};
    int what = 0;
    size_t wrong = 0;
    while (what < TASKS && count_of_words > 3 && strcmp(words[1], tasks[what].word) != 0)
        what++;
    for (int i = 3; i < count_of_words; i++)
        (void)glob(words[i], i > 3 ? GLOB_APPEND : 0, NULL, &paths);
    if (what == TASKS || paths.gl_pathc == 0) {
        fputs("usage: pictures --record|--check FILE SCENES...\n"
              "       pictures --draw FOLDER SCENES...\n",
              stderr);
        return 2;
    }
    FILE *list = tasks[what].mode ? open_list(words[2], tasks[what].mode) : NULL;
    if (tasks[what].mode && !list)
        return EXIT_FAILURE;
    for (size_t i = 0; i < paths.gl_pathc; i++)
        wrong += !do_scene(paths.gl_pathv[i], what, list, words[2]);
    wrong += tasks[what].of_scene == check && getc(list) != EOF; /* it has more scenes */
    printf("%zu passed, %zu failed\n", paths.gl_pathc, wrong);
    globfree(&paths);
    return (list && fclose(list) != 0) || wrong > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
