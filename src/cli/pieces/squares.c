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

/* Calls `visit` for each pixel of them, in their order, until it returns false. */
typedef bool pixel_visitor(void *context, size_t pixel);

static bool each_pixel(const squares *of, const index_ranges *which, pixel_visitor *visit,
                       void *context)
{
    const picture *image = &of->drawn->image;
    for (size_t i = 0; i < which->count; i++) {
        for (uint64_t n = which->of[i].first; n < which->of[i].end; n++) {
            const picture_part at = render_square(image->width, image->height, (int64_t)n);
            for (int p = 0; p < at.width * at.height; p++) {
                size_t row = (size_t)(at.y + p / at.width), column = (size_t)(at.x + p % at.width);
                if (!visit(context, row * (size_t)image->width + column))
                    return false;
            }
        }
    }
    return true;
}

static bool count_pixel(void *context, size_t pixel)
{
    (void)pixel;
    ++*(size_t *)context;
    return true;
}

/* Light. */

typedef struct {
    picture *image;
    uint8_t *at; /* in the bytes of the pixels, one after the other */
} copying;

static bool copy_from(void *context, size_t pixel)
{
    copying *of = context;
    memcpy(of->at, &of->image->rgb[3 * pixel], 3);
    of->at += 3;
    return true;
}

static bool copy_to(void *context, size_t pixel)
{
    copying *of = context;
    memcpy(&of->image->rgb[3 * pixel], of->at, 3);
    of->at += 3;
    return true;
}

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

static json_t *light(const squares *of, const index_ranges *done, size_t pixels)
{
    uint8_t *bytes = malloc(3 * pixels + 1);
    json_t *made = NULL;
    if (bytes && each_pixel(of, done, copy_from, &(copying){&of->drawn->image, bytes}))
        made = pack(bytes, 3 * pixels);
    free(bytes);
    return made;
}

static bool take_light(const squares *of, const index_ranges *done, size_t pixels,
                       const json_t *from)
{
    uint8_t *bytes = malloc(3 * pixels + 1);
    bool taken = bytes && unpack(from, bytes, 3 * pixels) &&
                 each_pixel(of, done, copy_to, &(copying){&of->drawn->image, bytes});
    free(bytes);
    return taken;
}

/* Claims: what a certificate says of the pixels. */

typedef struct {
    const squares *of;
    picture_part part;
    json_t *lines;
    size_t next;
} claiming;

static claiming claiming_of(const squares *of, json_t *lines)
{
    picture_part part = of->settings.how.part;
    part.width = of->drawn->image.width;
    part.height = of->drawn->image.height;
    return (claiming){of, part, lines, 0};
}

static bool claim_pixel(void *context, size_t pixel)
{
    const claiming *c = context;
    char words[CLAIM_WORDS];
    sure_ray ray = certificate_ray(&c->of->placed->scene, &c->part, pixel);
    claim_print(&(pixel_claim){ray.direction, c->of->drawn->records[pixel]}, words);
    return json_array_append_new(c->lines, json_string(words)) == 0;
}

static bool take_pixel(void *context, size_t pixel)
{
    claiming *c = context;
    const char *words = json_string_value(json_array_get(c->lines, c->next++));
    pixel_claim claim;
    if (!words || !claim_read(words, c->of->placed->scene.object_count, &claim))
        return false;
    c->of->drawn->records[pixel] = claim.pixel;
    return true;
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
    size_t pixels = 0;
    each_pixel(of, done, count_pixel, &pixels);
    json_t *said = json_pack("{s:o}", "rgb", light(of, done, pixels));
    if (said && of->drawn->records) {
        claiming c = claiming_of(of, json_array());
        bool all = each_pixel(of, done, claim_pixel, &c);
        json_object_set_new(said, "claims", all ? c.lines : NULL);
    }
    if (said && of->settings.counted)
        json_object_set_new(said, "counts", json_counts(counts_of(&of->drawn->statistics), COUNTS));
    return said;
}

static const char *add(void *sum, const index_ranges *done, const json_t *told)
{
    const squares *of = sum;
    size_t pixels = 0;
    each_pixel(of, done, count_pixel, &pixels);
    if (!take_light(of, done, pixels, json_object_get(told, "rgb")))
        return "expected the pixels of its squares";
    claiming c = claiming_of(of, json_object_get(told, "claims"));
    if (of->drawn->records &&
        (json_array_size(c.lines) != pixels || !each_pixel(of, done, take_pixel, &c)))
        return "expected what the pixels of its squares see";
    if (of->settings.counted && !take_counts(of, json_object_get(told, "counts")))
        return "expected counts of rays";
    return NULL;
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
