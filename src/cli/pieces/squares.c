/* SPDX-License-Identifier: MIT */
#include "squares.h"

#include "../../evidence/certificate.h"
#include "../../support/base64.h"
#include "../../support/json_file.h"
#include "../../support/pieces/cut.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

typedef struct {
    const char *path;
    const placed_scene *placed;
    render_settings settings;
    rendering *drawn;
} squares;

/* The pixels of these squares by their places in the picture, in their order, to be freed; NULL: no
 * memory. */
static size_t *pixels_of(const squares *of, const index_ranges *which, size_t *count)
{
    const picture *image = &of->drawn->image;
    const size_t width = (size_t)image->width;
    size_t *all = malloc(width * (size_t)image->height * sizeof *all);
    *count = 0;
    for (size_t i = 0; all && i < which->count; i++) {
        for (uint64_t n = which->of[i].first; n < which->of[i].end; n++) {
            const picture_part at = render_square(image->width, image->height, (int64_t)n);
            for (int p = 0; p < at.width * at.height; p++)
                all[(*count)++] =
                    (size_t)(at.y + p / at.width) * width + (size_t)(at.x + p % at.width);
        }
    }
    return all;
}

/* Light: the bytes of the pixels, one after the other. */

/* Compressed, as text. */
static json_t *pack(const uint8_t *bytes, size_t size)
{
    uLongf packed = compressBound(size);
    uint8_t *to = malloc(packed);
    char *text = to && compress(to, &packed, bytes, size) == Z_OK ? base64_of(to, packed) : NULL;
    json_t *made = text ? json_string(text) : NULL;
    free(text);
    free(to);
    return made;
}

static bool unpack(const json_t *from, uint8_t *bytes, size_t size)
{
    uLongf unpacked = size;
    size_t length = 0;
    uint8_t *packed = base64_bytes(json_string_value(from), &length);
    uLong read = length;
    bool done = packed && uncompress2(bytes, &unpacked, packed, &read) == Z_OK &&
                unpacked == size && read == length;
    free(packed);
    return done;
}

static json_t *light(const squares *of, const size_t *pixels, size_t count)
{
    uint8_t *bytes = malloc(3 * count + 1);
    for (size_t i = 0; bytes && i < count; i++)
        memcpy(bytes + 3 * i, of->drawn->image.rgb + 3 * pixels[i], 3);
    json_t *made = bytes ? pack(bytes, 3 * count) : NULL;
    free(bytes);
    return made;
}

static bool take_light(const squares *of, const size_t *pixels, size_t count, const json_t *from)
{
    uint8_t *bytes = malloc(3 * count + 1);
    bool taken = bytes && unpack(from, bytes, 3 * count);
    for (size_t i = 0; taken && i < count; i++)
        memcpy(of->drawn->image.rgb + 3 * pixels[i], bytes + 3 * i, 3);
    free(bytes);
    return taken;
}

/* Claims: what a certificate says of the pixels. NULL: no memory. */

static json_t *claims(const squares *of, const size_t *pixels, size_t count)
{
    json_t *lines = json_array();
    picture_part part = of->settings.how.part;
    part.width = of->drawn->image.width;
    part.height = of->drawn->image.height;
    for (size_t i = 0; i < count; i++) {
        char words[CLAIM_WORDS];
        sure_ray ray = certificate_ray(&of->placed->scene, &part, pixels[i]);
        claim_print(&(pixel_claim){ray.direction, of->drawn->records[pixels[i]]}, words);
        json_array_append_new(lines, json_string(words));
    }
    return lines;
}

static bool take_claims(const squares *of, const size_t *pixels, size_t count, const json_t *lines)
{
    bool taken = json_array_size(lines) == count;
    for (size_t i = 0; taken && i < count; i++) {
        const char *words = json_string_value(json_array_get(lines, i));
        pixel_claim claim;
        taken = words && claim_read(words, of->placed->scene.object_count, &claim);
        if (taken)
            of->drawn->records[pixels[i]] = claim.pixel;
    }
    return taken;
}

/* All of it. */

/* From `rays` on all of them are counts. */
#define COUNTS (int)((sizeof(sure_statistics) - offsetof(sure_statistics, rays)) / sizeof(uint64_t))

static uint64_t *counts_of(sure_statistics *of)
{
    return (uint64_t *)(void *)((char *)of + offsetof(sure_statistics, rays));
}

static bool take_counts(const squares *of, const json_t *from)
{
    sure_statistics more = of->drawn->statistics; /* but for its counts */
    bool taken = json_array_size(from) == COUNTS;
    for (int i = 0; taken && i < COUNTS; i++)
        taken = json_take_count(json_array_get(from, (size_t)i), counts_of(&more) + i);
    if (taken)
        sure_statistics_add(&of->drawn->statistics, &more);
    return taken;
}

static bool work(void *sum, index_range some)
{
    squares *of = sum;
    of->settings.how.first_square = (int64_t)some.first;
    of->settings.how.end_square = (int64_t)some.end;
    return rendering_draw(of->path, of->placed, &of->settings, stderr, of->drawn);
}

static json_t *tell(const void *sum, const index_ranges *done)
{
    const squares *of = sum;
    size_t count;
    size_t *pixels = pixels_of(of, done, &count);
    json_t *said = pixels ? json_pack("{s:o}", "rgb", light(of, pixels, count)) : NULL;
    if (said && of->drawn->records)
        json_object_set_new(said, "claims", claims(of, pixels, count));
    if (said && of->settings.counted)
        json_object_set_new(said, "counts", json_counts(counts_of(&of->drawn->statistics), COUNTS));
    free(pixels);
    return said;
}

static const char *add(void *sum, const index_ranges *done, const json_t *told)
{
    const squares *of = sum;
    size_t count;
    size_t *pixels = pixels_of(of, done, &count);
    const char *wrong = NULL;
    if (!pixels)
        wrong = "no memory";
    else if (!take_light(of, pixels, count, json_object_get(told, "rgb")))
        wrong = "expected the pixels of its squares";
    else if (of->drawn->records && !take_claims(of, pixels, count, json_object_get(told, "claims")))
        wrong = "expected what the pixels of its squares see";
    else if (of->settings.counted && !take_counts(of, json_object_get(told, "counts")))
        wrong = "expected counts of rays";
    free(pixels);
    return wrong;
}

int squares_do(const char *scene, const placed_scene *placed, const render_settings *settings,
               rendering *drawn)
{
    squares of = {scene, placed, *settings, drawn};
    of.settings.how.goes_on = cut_goes_on;
    if (of.settings.how.threads == 0)
        of.settings.how.threads = 1; /* there are pieces for all cores */
    return cut_do(
        &(cut_work){.unit = "squares",
                    .total = (uint64_t)render_squares(drawn->image.width, drawn->image.height),
                    .input = {scene, placed->hash},
                    .sum = &of,
                    .work = work,
                    .tell = tell,
                    .add = add});
}
