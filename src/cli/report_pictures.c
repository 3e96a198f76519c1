#define _POSIX_C_SOURCE 200809L /* mkdtemp */

#include "report_pictures.h"

#include "../image/picture.h"
#include "../scene/placement.h"
#include "../tracer/render.h"
#include "../scene/rt.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NOTE 160

static const struct {
    const char *title, *text, *file;
} subjects[REPORT_SCENES] = {
    {"A ball of radius 1, thirty million away",
     "It fills the frame of a very long lens. The square of the distance is near 10<sup>15</sup>: "
     "beside it, a float (7 digits) does not see the radius at all, and a double (16 digits) keeps "
     "one digit of it, unless the formula takes the two apart first.",
     "A 0.15 255,255,255\n"
     "C 0,0,30000000 0,0,-1 4.125e-6\n"
     "L 18000000,21000000,27000000 0.85\n"
     "sp 0,0,0 2 206,92,70\n"
     "R 160 160\n"},
    {"A cylinder and a cone, ten million away",
     "The same with more terms that cancel. Speckles are rays that miss what they should hit.",
     "A 0.15 255,255,255\n"
     "C 0,0,10000000 0,0,-1 2.177e-5\n"
     "L 6000000,7000000,9000000 0.85\n"
     "cy -0.85,0,0 0.3,1,0.35 1.1 2.2 80,140,210\n"
     "co 0.9,0,0 -0.3,1,0.3 1.5 2.3 120,180,90\n"
     "R 160 160\n"},
};

/* A PNG in memory, by way of a file: the tracer writes no other. */

static bool read_bytes(const char *path, report_png *to)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return false;
    long size = fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;
    unsigned char *bytes = size > 0 ? malloc((size_t)size) : NULL;
    rewind(in);
    bool whole = bytes && fread(bytes, 1, (size_t)size, in) == (size_t)size;
    fclose(in);
    if (!whole) {
        free(bytes);
        return false;
    }
    to->bytes = bytes;
    to->size = (size_t)size;
    return true;
}

static bool to_png(const picture *image, report_png *to)
{
    char path[4096];
    const char *folder = getenv("TMPDIR");
    int length = snprintf(path, sizeof path - 16, "%s/surehit-XXXXXX", folder ? folder : "/tmp");
    if (length < 0 || (size_t)length >= sizeof path - 16 || !mkdtemp(path)) {
        fprintf(stderr, "surehit report: error: no temporary folder: %s\n", strerror(errno));
        return false;
    }
    strcpy(path + length, "/picture.png");
    bool done = picture_write(image, path, stderr) && read_bytes(path, to);
    unlink(path);
    path[length] = '\0';
    rmdir(path);
    return done;
}

/* Where a picture differs from the right one: there the colour says how much, from yellow to red;
 * else the right one, grey and pale. */
static int difference(const picture *image, const picture *right, picture *to)
{
    int count = 0;
    for (size_t i = 0; i < 3 * (size_t)image->width * (size_t)image->height; i += 3) {
        const uint8_t *is = image->rgb + i, *should = right->rgb + i;
        int most = 0;
        for (int c = 0; c < 3; c++)
            most = abs(is[c] - should[c]) > most ? abs(is[c] - should[c]) : most;
        uint8_t grey = (uint8_t)(225 + (should[0] + should[1] + should[2]) / 28);
        to->rgb[i] = most == 0 ? grey : (uint8_t)(240 - most / 3);
        to->rgb[i + 1] = most == 0 ? grey : (uint8_t)(most < 40 ? 170 - 4 * most : 10);
        to->rgb[i + 2] = most == 0 ? grey : 20;
        count += most > 0;
    }
    return count;
}

/* A scene. */

typedef struct {
    picture drawn[SURE_TIERS], apart;
    report_picture shown[SURE_TIERS];
    char notes[SURE_TIERS][NOTE];
} album;

static bool draw_tiers(const char *text, album *all)
{
    rt_options reading = rt_default_options();
    rt_options_set set = {false};
    rt_scene file;
    sure_scene scene;
    if (!rt_read_text(text, strlen(text), "the report's scene", &reading, &set, stderr, &file))
        return false;
    bool done = placement(&file, stderr, &scene);
    rt_scene_free(&file);
    if (!done)
        return false;
    done = picture_new(scene.width, scene.height, &all->apart);
    for (int tier = 0; done && tier < SURE_TIERS; tier++) {
        const render_options how = {.tier = (sure_tier)tier};
        done = picture_new(scene.width, scene.height, &all->drawn[tier]);
        if (done)
            render(&scene, &how, &all->drawn[tier]);
    }
    placement_free(&scene);
    return done;
}

static bool show_difference(album *all, int tier)
{
    char *note = all->notes[tier];
    int pixels = all->apart.width * all->apart.height;
    int apart = difference(&all->drawn[tier], &all->drawn[SURE_TIER_EXACT], &all->apart);
    if (apart == 0)
        snprintf(note, NOTE, "every pixel as exact");
    else
        snprintf(note, NOTE, "%.*f %% of the pixels wrong", apart * 10 < pixels ? 1 : 0,
                 100.0 * apart / pixels);
    return to_png(&all->apart, &all->shown[tier].apart);
}

static bool show(album *all, int tier)
{
    report_picture *to = &all->shown[tier];
    to->name = sure_tier_name((sure_tier)tier);
    to->note = all->notes[tier];
    to->width = all->apart.width;
    to->height = all->apart.height;
    snprintf(all->notes[tier], NOTE, "the right picture");
    return to_png(&all->drawn[tier], &to->drawn) &&
           (tier == SURE_TIER_EXACT || show_difference(all, tier));
}

static bool show_all(album *all)
{
    for (int tier = 0; tier < SURE_TIERS; tier++) {
        if (!show(all, tier))
            return false;
    }
    return true;
}

static album albums[REPORT_SCENES];

static bool draw_scene(int i, report_scene *scene)
{
    *scene = (report_scene){subjects[i].title, subjects[i].text, subjects[i].file, albums[i].shown,
                            SURE_TIERS};
    return draw_tiers(subjects[i].file, &albums[i]) && show_all(&albums[i]);
}

bool report_pictures_draw(report_scene scenes[REPORT_SCENES], int *count)
{
    *count = 0;
#ifdef SUREHIT_PNG
    while (*count < REPORT_SCENES) {
        int i = (*count)++;
        if (!draw_scene(i, &scenes[i]))
            return false;
    }
#else
    (void)scenes;
    (void)draw_scene;
#endif
    return true;
}

void report_pictures_free(int count)
{
    for (int i = 0; i < count; i++) {
        for (int tier = 0; tier < SURE_TIERS; tier++) {
            free(albums[i].shown[tier].drawn.bytes);
            free(albums[i].shown[tier].apart.bytes);
            picture_free(&albums[i].drawn[tier]);
        }
        picture_free(&albums[i].apart);
    }
}
