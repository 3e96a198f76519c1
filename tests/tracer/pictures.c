/* The extreme scenes by every tier: pixels of a wrong object, pixels of a wrong colour, time.
 *
 *   pictures --record FILE SCENE...    writes the record, docs/pictures.csv
 *   pictures --check FILE SCENE...     counts anew, but for the truth, and compares
 *   pictures --draw FOLDER SCENE...    a PNG a scene: each tier's picture, below it what is wrong
 *
 * SCENE is a file, or a folder for all of its scenes. */
#include "../support/sights.h"

#include "placement.h"
#include "progress.h"
#include "render_file.h"
#include "rt.h"

#include <inttypes.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, ROUNDS = 5, NAME_MOST = 64 };

static const char head[] = "scene,tier,pixels,wrong,wrong_by_exact,wrong_color,microseconds\n";

/* What a tier makes of a scene. */
typedef struct {
    picture image;
    sights seen;
    int wrong, wrong_by_exact, wrong_color;
    double seconds[ROUNDS];
} view;

typedef struct {
    char name[NAME_MOST];
    rt_scene file;
    sure_scene scene;
    sights truth;
    view views[SURE_TIERS];
} subject;

/* The file's name without folder and ending. */
static void name_of(const char *path, char name[NAME_MOST])
{
    const char *slash = strrchr(path, '/');
    snprintf(name, NAME_MOST, "%s", slash ? slash + 1 : path);
    name[strcspn(name, ".")] = '\0';
}

static bool load(const char *path, subject *s)
{
    const rt_options options = rt_default_options();
    memset(s, 0, sizeof *s);
    name_of(path, s->name);
    if (!rt_read(path, &options, 0, stderr, &s->file))
        return false;
    s->file.options.width = WIDTH;
    s->file.options.height = HEIGHT;
    if (placement(&s->file, stderr, &s->scene))
        return true;
    rt_scene_free(&s->file);
    return false;
}

static void unload(subject *s)
{
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        picture_free(&s->views[tier].image);
        sights_free(&s->views[tier].seen);
    }
    sights_free(&s->truth);
    placement_free(&s->scene);
    rt_scene_free(&s->file);
}

static void draw(const subject *s, sure_tier tier, picture *image)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1},
                                      .integrator = INTEGRATOR_BACKWARD};
    render_scene(&s->scene, &settings, image);
}

/* Colours that are the same but for their rounding to a byte are at most one level apart. */
static bool is_wrong_color(const uint8_t *rgb, const uint8_t *expected)
{
    return abs(rgb[0] - expected[0]) > 1 || abs(rgb[1] - expected[1]) > 1 ||
           abs(rgb[2] - expected[2]) > 1;
}

static int wrong_colors(const picture *image, const picture *expected)
{
    int wrong = 0;
    for (int i = 0; i < PIXELS; i++)
        wrong += is_wrong_color(image->rgb + 3 * i, expected->rgb + 3 * i);
    return wrong;
}

static void need(bool memory)
{
    if (!memory) {
        fprintf(stderr, "pictures: error: no memory\n");
        exit(EXIT_FAILURE);
    }
}

static void count(subject *s)
{
    const view *exact = &s->views[SURE_TIER_EXACT];
    for (int tier = SURE_TIERS - 1; tier >= 0; tier--) {
        view *v = &s->views[tier];
        need(picture_new(WIDTH, HEIGHT, &v->image) &&
             sights_drawn(&s->scene, (sure_tier)tier, &v->seen));
        draw(s, (sure_tier)tier, &v->image);
        v->wrong_by_exact = sights_differ(&v->seen, &exact->seen);
        v->wrong_color = wrong_colors(&v->image, &exact->image);
    }
}

static int by_size(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* The median of some rounds, the tiers in turn. */
static void time_frames(subject *s)
{
    for (int round = 0; round < ROUNDS; round++) {
        for (int tier = 0; tier < SURE_TIERS; tier++) {
            double started = progress_clock();
            draw(s, (sure_tier)tier, &s->views[tier].image);
            s->views[tier].seconds[round] = progress_clock() - started;
        }
    }
    for (int tier = 0; tier < SURE_TIERS; tier++)
        qsort(s->views[tier].seconds, ROUNDS, sizeof(double), by_size);
}

/* All but the time. */
static const char *row_of(const subject *s, int tier)
{
    static char row[256];
    const view *v = &s->views[tier];
    snprintf(row, sizeof row, "%s,%s,%d,%d,%d,%d,", s->name, sure_tier_name((sure_tier)tier),
             PIXELS, v->wrong, v->wrong_by_exact, v->wrong_color);
    return row;
}

static bool record(subject *s, FILE *out)
{
    need(sights_true(&s->scene, &s->truth));
    time_frames(s);
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        view *v = &s->views[tier];
        v->wrong = sights_differ(&v->seen, &s->truth);
        fprintf(out, "%s%.0f\n", row_of(s, tier), 1e6 * v->seconds[ROUNDS / 2]);
    }
    return true;
}

/* The record's next lines against what is counted now; what the truth says is taken from there. */
static bool check(subject *s, FILE *in)
{
    bool same = true;
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
enum { COLUMNS = 4, GAP = 2, SHEET_WIDTH = COLUMNS * (WIDTH + GAP) - GAP };
static const sure_tier shown[COLUMNS] = {SURE_TIER_FLOAT32, SURE_TIER_TEXTBOOK, SURE_TIER_STABLE,
                                         SURE_TIER_CERTAIN};

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
    const view *v = &s->views[shown[column]];
    for (int i = 0; i < PIXELS; i++) {
        int x = column * (WIDTH + GAP) + i % WIDTH, y = i / WIDTH;
        memcpy(sheet->rgb + 3 * (y * SHEET_WIDTH + x), v->image.rgb + 3 * i, 3);
        mark(s, v, i, sheet->rgb + 3 * ((y + HEIGHT + GAP) * SHEET_WIDTH + x));
    }
}

/* Nothing for a scene that every tier draws right. */
static bool draw_sheet(const subject *s, const char *folder)
{
    char path[4096];
    picture sheet;
    int wrong = 0;
    for (int tier = 0; tier < SURE_TIERS; tier++)
        wrong += s->views[tier].wrong_by_exact + s->views[tier].wrong_color;
    if (wrong == 0)
        return true;
    need(picture_new(SHEET_WIDTH, 2 * HEIGHT + GAP, &sheet));
    memset(sheet.rgb, 255, 3 * (size_t)sheet.width * (size_t)sheet.height);
    for (int column = 0; column < COLUMNS; column++)
        fill_panel(s, column, &sheet);
    snprintf(path, sizeof path, "%s/%s.png", folder, s->name);
    bool written = picture_write(&sheet, path, stderr);
    picture_free(&sheet);
    return written;
}

typedef enum { RECORD, CHECK, DRAW } task;

static bool do_scene(const char *path, task what, FILE *list, const char *folder)
{
    subject s;
    if (!load(path, &s))
        return false;
    count(&s);
    bool ok = what == RECORD  ? record(&s, list)
              : what == CHECK ? check(&s, list)
                              : draw_sheet(&s, folder);
    unload(&s);
    return ok;
}

static FILE *open_list(const char *path, task what)
{
    char line[sizeof head];
    FILE *list = fopen(path, what == RECORD ? "w" : "r");
    if (!list)
        perror(path);
    else if (what == RECORD)
        fputs(head, list);
    else if (!fgets(line, sizeof line, list) || strcmp(line, head) != 0)
        fprintf(stderr, "%s: another head than this program writes\n", path);
    return list;
}

/* False when there is none. */
static bool find_scenes(char **words, int count_of_words, glob_t *paths)
{
    int status = 0;
    for (int i = 0; i < count_of_words && status == 0; i++) {
        const char *ending = strrchr(words[i], '.');
        char pattern[4096];
        bool one = ending && strcmp(ending, ".rt") == 0;
        snprintf(pattern, sizeof pattern, "%s%s", words[i], one ? "" : "/*.rt");
        status = glob(pattern, i > 0 ? GLOB_APPEND : 0, NULL, paths);
        if (status != 0)
            fprintf(stderr, "%s: no scene is found\n", pattern);
    }
    return status == 0;
}

static int do_all(const glob_t *paths, task what, const char *target)
{
    FILE *list = what == DRAW ? NULL : open_list(target, what);
    size_t wrong = 0;
    if (what != DRAW && !list)
        return EXIT_FAILURE;
    for (size_t i = 0; i < paths->gl_pathc; i++)
        wrong += !do_scene(paths->gl_pathv[i], what, list, target);
    printf("%zu passed, %zu failed\n", paths->gl_pathc - wrong, wrong);
    if (what == CHECK && getc(list) != EOF) {
        printf("%s: has more lines than there are scenes\n", target);
        wrong++;
    }
    return list && fclose(list) != 0 ? EXIT_FAILURE : wrong > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}

int main(int count_of_words, char **words)
{
    static const char *const tasks[] = {
        [RECORD] = "--record", [CHECK] = "--check", [DRAW] = "--draw"};
    glob_t paths;
    for (int what = RECORD; what <= DRAW && count_of_words > 3; what++) {
        if (strcmp(words[1], tasks[what]) != 0)
            continue;
        int status = EXIT_FAILURE;
        if (find_scenes(words + 3, count_of_words - 3, &paths))
            status = do_all(&paths, (task)what, words[2]);
        globfree(&paths);
        return status;
    }
    fputs(
        "usage: pictures --record|--check FILE SCENE...\n       pictures --draw FOLDER SCENE...\n",
        stderr);
    return 2;
}
