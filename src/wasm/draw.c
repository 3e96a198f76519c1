/* SPDX-License-Identifier: MIT */
/* The tracer for scripts: a scene's text, then its picture, tile by tile. */
#include "export.h"

#include "../evidence/claim.h"
#include "../hierarchy/bvh_build.h"
#include "../photons/map/caustics.h"
#include "../scene/placement.h"

#include <stdlib.h>
#include <string.h>

static char *text, *told;
static size_t text_size, told_size;

static sure_scene scene;
static sure_bvh bvh;
static sure_photon_map map;
static bool placed;

/* The tile that was drawn last. */
static certificate tile;
static uint8_t *pixels;

/* Room for a text of so many bytes. */
char *WASM_EXPORT(text_room)(size_t size)
{
    free(text);
    text_size = size;
    return text = malloc(size + 1);
}

/* Errors and warnings, a line each, of a file called scene. */
const char *WASM_EXPORT(messages)(void)
{
    return told ? told : "";
}

static void forget(void)
{
    if (scene.caustics)
        photon_map_free(&map);
    bvh_free(&bvh);
    if (placed)
        placement_free(&scene);
    free(told);
    told = NULL;
    placed = false;
    bvh = (sure_bvh){0};
}

/* As render_scene does, once for all tiles. */
static void light(void)
{
    const render_settings settings = RENDER_DEFAULTS;
    scene.bvh = bvh_for(&scene, true, 1, &bvh);
    caustics_statistics caustics = caustics_build(&scene, &settings, &map);
    scene.caustics = caustics.state == CAUSTICS_ON ? &map : NULL;
}

/* Of that size, whatever the scene says; width 0: of its own. 1, or 0 after messages. */
int WASM_EXPORT(read_scene)(int width, int height)
{
    rt_options options = RT_DEFAULTS;
    rt_scene file;
    if (width > 0) {
        options.width = width;
        options.height = height;
    }
    forget();
    FILE *messages = open_memstream(&told, &told_size);
    if (!messages || !text)
        return 0;
    if (rt_read_text(text, text_size, "scene", &options, width > 0 ? RT_SET(RT_SIZE) : 0, messages,
                     &file)) {
        placed = placement(&file, messages, &scene);
        rt_scene_free(&file);
    }
    fclose(messages);
    if (placed)
        light();
    return placed;
}

int WASM_EXPORT(scene_width)(void)
{
    return scene.width;
}

int WASM_EXPORT(scene_height)(void)
{
    return scene.height;
}

static void write_pixels(const picture *image, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        memcpy(pixels + 4 * i, image->rgb + 3 * i, 3);
        pixels[4 * i + 3] = 255;
    }
}

static void claim_all(const pixel_record *records, size_t count)
{
    for (size_t i = 0; i < count; i++)
        tile.claims[i] =
            (pixel_claim){certificate_ray(&scene, &tile.part, i).direction, records[i]};
}

static bool make_room(size_t count, pixel_record **records, picture *image)
{
    free(tile.claims);
    free(pixels);
    tile.claims = malloc(count * sizeof *tile.claims);
    pixels = malloc(4 * count);
    *records = malloc(count * sizeof **records);
    return tile.claims && pixels && *records &&
           picture_new(tile.part.width, tile.part.height, image);
}

/* Where its pixels are, four bytes each, or NULL; `claimed`: check_tile will be asked. */
uint8_t *WASM_EXPORT(draw_tile)(sure_tier tier, int x, int y, int width, int height, int claimed)
{
    const size_t count = (size_t)width * (size_t)height;
    pixel_record *records;
    picture image;
    tile.eye = scene.camera.position;
    tile.tier = tier;
    tile.part = (picture_part){x, y, width, height};
    if (!make_room(count, &records, &image)) {
        free(records);
        return NULL;
    }
    sure_float_object *floats = placement_floats(&scene, tier);
    sure_scene lit = scene;
    lit.floats = floats;
    const render_options how = {
        .tier = tier, .part = tile.part, .records = claimed ? records : NULL};
    render(&lit, &how, &image);
    write_pixels(&image, count);
    if (claimed)
        claim_all(records, count);
    picture_free(&image);
    free(floats);
    free(records);
    return pixels;
}

/* How many pixels of the last tile are not as the tier said, by exact. */
int WASM_EXPORT(check_tile)(void)
{
    const size_t count = (size_t)tile.part.width * (size_t)tile.part.height;
    int wrong = 0;
    for (size_t i = 0; i < count; i++) {
        sure_status seen;
        sure_nearest nearest;
        wrong += claim_check(&scene, &tile, i, &seen, &nearest) != CLAIM_RIGHT;
    }
    return wrong;
}
