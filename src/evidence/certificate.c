/* SPDX-License-Identifier: MIT */
#include "certificate.h"

#include "../numbers/digits/hex_float.h"
#include "../support/complain.h"
#include "../support/json_file.h"
#include "../scene/rt_notes.h"
#include "../tracer/visible.h"
#include "../support/atomic_file.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#define FORMAT 2
#define WORDS CLAIM_WORDS /* of an object, too */

void certificate_free(certificate *of)
{
    free(of->claims);
    json_decref(of->numbers);
    *of = (certificate){0};
}

/* Counts by the names of what is counted. */

#define NAMING(what)                                                                               \
    static const char *what(int i)                                                                 \
    {                                                                                              \
        return sure_##what##_name((sure_##what)i);                                                 \
    }
NAMING(ray_kind)
NAMING(stage)
NAMING(part)

/* As they stand in sure_statistics from `missed` on. */
static const char *const totals[] = {"misses", "origins", "without-origin", "covered", "acne"};
#define TOTALS (int)(sizeof totals / sizeof *totals)

static const char *total(int i)
{
    return totals[i];
}

/* What the answers are about. */

json_t *certificate_numbers(const sure_scene *scene)
{
    json_t *all = json_array();
    for (size_t i = 0; all && i < scene->object_count; i++) {
        const sure_object *object = &scene->objects[i];
        const sure_shape_info *info = sure_shape_info_of(object->shape);
        char words[WORDS];
        int at = snprintf(words, sizeof words, "%s", info->name);
        for (int k = 0; k < info->numbers; k++)
            at += snprintf(words + at, sizeof words - (size_t)at, " %s",
                           HEX(((const double *)&object->as)[k]));
        if (json_array_append_new(all, json_string(words)) != 0) {
            json_decref(all);
            return NULL;
        }
    }
    return all;
}

static size_t pixel_count(const picture_part *part)
{
    return (size_t)part->width * (size_t)part->height;
}

sure_ray certificate_ray(const sure_scene *scene, const picture_part *part, size_t i)
{
    const size_t width = (size_t)part->width;
    sure_ray ray = sure_scene_pixel_ray(scene, part->x + (int)(i % width),
                                        scene->height - 1 - part->y - (int)(i / width));
    ray.t_min = 0x1p-1074;
    return ray;
}

static int print_vector(sure_vec3 v, char words[WORDS])
{
    return snprintf(words, WORDS, "%s %s %s", HEX(v.x), HEX(v.y), HEX(v.z));
}

/* Taken as it comes, and right if it is written the same again. NULL, or what follows. */
static const char *take_vector(const char *text, sure_vec3 *v)
{
    char again[WORDS];
    if (sscanf(text, "%la %la %la", &v->x, &v->y, &v->z) != 3)
        return NULL;
    size_t length = (size_t)print_vector(*v, again);
    return strncmp(text, again, length) == 0 ? text + length : NULL;
}

/* Writing. */

static json_t *header_json(const certificate *of, const char *name, const sure_scene *scene)
{
    const sure_statistics *sum = &of->statistics;
    char tile[48], eye[WORDS], *printable = rt_printable_name(name);
    json_t *shown = printable ? json_string(printable) : NULL;
    free(printable);
    snprintf(tile, sizeof tile, "%d,%d,%dx%d", of->part.x, of->part.y, of->part.width,
             of->part.height);
    print_vector(scene->camera.position, eye);
    return json_pack("{s:i, s:o, s:o, s:I, s:o, s:s, s:s, s:s, s:o, s:o, s:o, s:o}",
                     "surehit certificate", FORMAT, "scene",
                     shown ? shown : json_string("(a name that is no UTF-8)"), "hash",
                     json_bits(of->hash), "objects", (json_int_t)scene->object_count, "numbers",
                     certificate_numbers(scene), "eye", eye, "part", tile, "tier",
                     sure_tier_name(of->tier), "options", rt_options_json(&of->options), "rays",
                     json_named_counts(ray_kind, sum->rays, SURE_RAY_KINDS), "hits",
                     json_named_counts(stage, sum->decided, SURE_STAGES), "totals",
                     json_named_counts(total, &sum->missed, TOTALS));
}

void claim_print(const pixel_claim *one, char words[CLAIM_WORDS])
{
    const pixel_record *pixel = &one->pixel;
    int at = print_vector(one->direction, words);
    if (pixel->seen == SURE_HIT)
        snprintf(words + at, (size_t)(WORDS - at), " %" PRIu32 " %s %s %s %s", pixel->object,
                 part(pixel->part), stage(pixel->stage), HEX(pixel->t), HEX(pixel->t_error));
    else
        strcpy(words + at, " miss");
}

bool certificate_write(const certificate *of, const char *name, const sure_scene *scene,
                       const pixel_record *records, const char *path)
{
    atomic_file file;
    json_t *header = header_json(of, name, scene);
    if (!header)
        return complain(stderr, path, "no memory");
    bool opened = atomic_file_open(path, stderr, &file);
    if (opened)
        json_dumpf(header, file.stream, JSON_INDENT(2));
    json_decref(header);
    if (!opened)
        return false;
    fputc('\n', file.stream);
    for (size_t i = 0; i < pixel_count(&of->part) && !ferror(file.stream); i++) {
        char words[WORDS];
        sure_ray ray = certificate_ray(scene, &of->part, i);
        claim_print(&(pixel_claim){ray.direction, records[i]}, words);
        fprintf(file.stream, "%s\n", words);
    }
    return atomic_file_finish(&file, stderr);
}

/* Reading. */

typedef struct {
    FILE *file;
    const char *path;
    char *line; /* without its end */
    size_t capacity, number;
} reader;

static bool wrong(const reader *r, const char *what)
{
    printable_printf(stderr, "%s:%zu: error: %s", r->path, r->number, what);
    fputc('\n', stderr);
    return false;
}

static bool next_line(reader *r)
{
    ssize_t length = getline(&r->line, &r->capacity, r->file);
    r->number++;
    if (length < 0)
        return wrong(r, feof(r->file) ? "the certificate ends too early" : strerror(errno));
    if (r->line[length - 1] != '\n' || strlen(r->line) != (size_t)length)
        return wrong(r, "no whole line of text");
    r->line[length - 1] = '\0';
    return true;
}

/* Returns what is wrong, or NULL. */
static const char *take_header(json_t *header, certificate *read, json_error_t *error)
{
    sure_statistics *sum = &read->statistics;
    const char *tile, *tier, *eye, *end, *unread;
    json_t *hash, *options, *rays, *hits, *all, *numbers;
    json_int_t objects, format;
    if (json_unpack_ex(header, error, 0,
                       "{s:I, s:s, s:o, s:I, s:o, s:s, s:s, s:s, s:o, s:o, s:o, s:o!}",
                       "surehit certificate", &format, "scene", &unread, "hash", &hash, "objects",
                       &objects, "numbers", &numbers, "eye", &eye, "part", &tile, "tier", &tier,
                       "options", &options, "rays", &rays, "hits", &hits, "totals", &all) != 0)
        return error->text;
    if (format != FORMAT)
        return "another format";
    if (!json_take_bits(hash, &read->hash))
        return "expected 16 hexadecimal digits for the hash";
    if (objects < 0 || objects > UINT32_MAX)
        return "expected as many objects as a scene can have";
    if (json_array_size(numbers) != (size_t)objects)
        return "expected the numbers of as many objects";
    if (!(end = take_vector(eye, &read->eye)) || *end)
        return "expected the eye's three coordinates";
    if (!sure_tier_from_name(tier, &read->tier) || !is_sure(read->tier))
        return "expected tier 'certain' or 'exact'";
    const char *option = rt_options_from_json(options, &read->options);
    if (option)
        return option;
    if (!render_part_from(tile, &read->part) ||
        !render_part_fits(&read->part, read->options.width, read->options.height))
        return "expected a part of the picture, X,Y,WxH";
    if (!json_take_named_counts(rays, ray_kind, sum->rays, SURE_RAY_KINDS) ||
        !json_take_named_counts(hits, stage, sum->decided, SURE_STAGES) ||
        !json_take_named_counts(all, total, &sum->missed, TOTALS))
        return "expected counts of rays, hits and totals";
    read->numbers = json_incref(numbers);
    return NULL;
}

/* For jansson, a character at a time: what stands behind the head is not for it. */
static size_t next_character(void *to, size_t size, void *from)
{
    reader *r = from;
    int c = size > 0 ? getc(r->file) : EOF;
    *(char *)to = (char)c;
    r->number += c == '\n';
    return c != EOF;
}

static bool read_header(reader *r, certificate *read)
{
    json_error_t error;
    json_t *header = json_load_callback(next_character, r,
                                        JSON_DISABLE_EOF_CHECK | JSON_REJECT_DUPLICATES, &error);
    r->number = header ? r->number + 1 : (size_t)error.line; /* may have read beyond a word */
    if (!header)
        return wrong(r, ferror(r->file) ? strerror(errno) : error.text);
    const char *what = take_header(header, read, &error);
    json_decref(header);
    if (!what && getc(r->file) != '\n')
        what = "expected the pixels on lines of their own";
    return !what || wrong(r, what);
}

static int number_of(const char *word, json_naming *name, int count)
{
    int i = count - 1;
    while (i >= 0 && strcmp(word, name(i)) != 0)
        i--;
    return i;
}

bool claim_read(const char *line, size_t objects, pixel_claim *read)
{
    char of_part[16], of_stage[16], again[WORDS];
    pixel_record *pixel = &read->pixel;
    const char *words = take_vector(line, &read->direction);
    *pixel = (pixel_record){.seen = SURE_MISS};
    if (words && sscanf(words, "%" SCNu32 " %15s %15s %la %la", &pixel->object, of_part, of_stage,
                        &pixel->t, &pixel->t_error) == 5) {
        int found_part = number_of(of_part, part, SURE_PARTS);
        int found_stage = number_of(of_stage, stage, SURE_STAGES);
        if (found_part < 0 || found_stage < 0 || pixel->object >= objects ||
            isnan(pixel->t + pixel->t_error) || signbit(pixel->t) || signbit(pixel->t_error))
            return false;
        pixel->seen = SURE_HIT;
        pixel->part = (uint8_t)found_part;
        pixel->stage = (uint8_t)found_stage;
    }
    claim_print(read, again);
    return strcmp(line, again) == 0;
}

/* Room that grows with what is read, not with what the header claims. */
static bool make_room(const reader *r, certificate *read, size_t count, size_t *room)
{
    if (count < *room)
        return true;
    *room = *room > 0 ? 2 * *room : 4096;
    pixel_claim *larger = realloc(read->claims, *room * sizeof *larger);
    if (larger)
        read->claims = larger;
    return larger || wrong(r, "no memory");
}

static bool read_claims(reader *r, certificate *read)
{
    size_t room = 0;
    for (size_t i = 0; i < pixel_count(&read->part); i++) {
        if (!next_line(r) || !make_room(r, read, i, &room))
            return false;
        if (!claim_read(r->line, json_array_size(read->numbers), &read->claims[i]))
            return wrong(r, "expected a direction, then 'miss' or an object's number, part, stage, "
                            "t and its error");
    }
    r->number++;
    return getc(r->file) == EOF || wrong(r, "more pixels than the part has");
}

bool certificate_read(const char *path, certificate *read)
{
    reader r = {.path = path};
    *read = (certificate){.options = rt_default_options()};
    r.file = fopen(path, "rb");
    if (!r.file)
        return complain(stderr, path, "%s", strerror(errno));
    bool done = read_header(&r, read) && read_claims(&r, read);
    free(r.line);
    fclose(r.file);
    if (!done)
        certificate_free(read);
    return done;
}
