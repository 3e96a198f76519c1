#define _POSIX_C_SOURCE 200809L /* strdup, stat */

#include "certificate.h"

#include "../support/fnv.h"
#include "../scene/resolved.h"
#include "../support/text_fields.h"
#include "../tracer/visible.h"
#include "../support/atomic_file.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>

static const char title[] = "surehit certificate 1";

static bool complain(FILE *messages, const char *path, const char *what)
{
    fprintf(messages, "%s: error: %s\n", path, what);
    return false;
}

bool certificate_hash(const char *scene, FILE *messages, uint64_t *hash)
{
    struct stat about;
    if (stat(scene, &about) != 0)
        return complain(messages, scene, strerror(errno));
    if (!S_ISREG(about.st_mode))
        return complain(messages, scene, "a certificate is of a scene in a file, as a share is");
    FILE *file = fopen(scene, "rb");
    if (!file)
        return complain(messages, scene, strerror(errno));
    unsigned char bytes[65536];
    size_t count;
    *hash = FNV_START;
    while ((count = fread(bytes, 1, sizeof bytes, file)) > 0)
        *hash = fnv_add(*hash, bytes, count);
    bool whole = !ferror(file);
    fclose(file);
    return whole || complain(messages, scene, "cannot be read");
}

void certificate_free(certificate *of)
{
    free(of->scene);
    free(of->records);
    *of = (certificate){0};
}

/* Writing. */

static void print_totals(FILE *out, const sure_statistics *sum)
{
    fputs("rays", out);
    for (int kind = 0; kind < SURE_RAY_KINDS; kind++)
        fprintf(out, " %s %" PRIu64, sure_ray_kind_name((sure_ray_kind)kind), sum->rays[kind]);
    fputs("\nhits", out);
    for (int stage = 0; stage < SURE_STAGES; stage++)
        fprintf(out, " %s %" PRIu64, sure_stage_name((sure_stage)stage), sum->decided[stage]);
    fprintf(out, "\nmisses %" PRIu64 "\norigins %" PRIu64, sum->missed, sum->origins);
    fprintf(out, "\nwithout-origin %" PRIu64, sum->without_origin);
    fprintf(out, "\ncovered %" PRIu64 "\nacne %" PRIu64 "\n", sum->covered, sum->acne);
}

static void print_header(FILE *out, const certificate *of)
{
    const picture_part *part = &of->part;
    fprintf(out, "%s\nscene %s\nhash %016" PRIx64 "\nobjects %zu\n", title, of->scene, of->hash,
            of->objects);
    fprintf(out, "size %dx%d\n", of->options.width, of->options.height);
    fprintf(out, "part %d,%d,%dx%d\n", part->x, part->y, part->width, part->height);
    fprintf(out, "tier %s\n", sure_tier_name(of->tier));
    resolved_print(out, &of->options);
    print_totals(out, &of->statistics);
    fputs("pixels\n", out);
}

static void print_pixel(FILE *out, const pixel_record *pixel)
{
    if (pixel->seen == SURE_HIT)
        fprintf(out, "%" PRIu32 " %s %s %a %a\n", pixel->object,
                sure_part_name((sure_part)pixel->part), sure_stage_name((sure_stage)pixel->stage),
                pixel->t, pixel->t_error);
    else
        fputs("miss\n", out);
}

static size_t pixel_count(const picture_part *part)
{
    return (size_t)part->width * (size_t)part->height;
}

bool certificate_write(const certificate *of, const char *path, FILE *messages)
{
    atomic_file file;
    if (!atomic_file_open(path, messages, &file))
        return false;
    print_header(file.stream, of);
    for (size_t i = 0; i < pixel_count(&of->part) && !ferror(file.stream); i++)
        print_pixel(file.stream, &of->records[i]);
    return atomic_file_finish(&file, messages);
}

/* Reading. */

/* The part or stage whose name stands next; -1: none. */

static int take_part(text_fields *r)
{
    for (int part = SURE_PART_WALL; part >= 0; part--) {
        if (text_takes(r, sure_part_name((sure_part)part)))
            return part;
    }
    return -1;
}

static int take_stage(text_fields *r)
{
    for (int stage = SURE_STAGES - 1; stage >= 0; stage--) {
        if (text_takes(r, sure_stage_name((sure_stage)stage)))
            return stage;
    }
    return -1;
}

static bool fits(int begin, int length, int whole)
{
    return begin <= whole && length <= whole - begin;
}

static bool read_part(text_fields *r, const rt_options *whole, picture_part *part)
{
    if (!text_next_field(r, "part"))
        return false;
    return (render_part_from(r->at, part) && fits(part->x, part->width, whole->width) &&
            fits(part->y, part->height, whole->height)) ||
           text_wrong(r, "expected a part of the picture, X,Y,WxH");
}

static bool read_tier(text_fields *r, sure_tier *tier)
{
    if (!text_next_field(r, "tier"))
        return false;
    return (sure_tier_from_name(r->at, tier) && is_sure(*tier)) ||
           text_wrong(r, "expected 'certain' or 'exact'");
}

static bool read_totals(text_fields *r, sure_statistics *sum)
{
    const char *kinds[SURE_RAY_KINDS], *stages[SURE_STAGES];
    for (int i = 0; i < SURE_RAY_KINDS; i++)
        kinds[i] = sure_ray_kind_name((sure_ray_kind)i);
    for (int i = 0; i < SURE_STAGES; i++)
        stages[i] = sure_stage_name((sure_stage)i);
    return text_read_counts(r, "rays", kinds, SURE_RAY_KINDS, sum->rays) &&
           text_read_counts(r, "hits", stages, SURE_STAGES, sum->decided) &&
           text_read_count(r, "misses", &sum->missed) &&
           text_read_count(r, "origins", &sum->origins) &&
           text_read_count(r, "without-origin", &sum->without_origin) &&
           text_read_count(r, "covered", &sum->covered) && text_read_count(r, "acne", &sum->acne);
}

static bool read_scene_name(text_fields *r, certificate *read)
{
    if (!text_next_field(r, "scene"))
        return false;
    read->scene = strdup(r->at);
    return read->scene || text_wrong(r, "no memory");
}

static bool read_header(text_fields *r, certificate *read)
{
    uint64_t objects;
    if (!text_next_line(r))
        return false;
    if (strcmp(r->line, title) != 0)
        return text_wrong(r, "expected '%s'", title);
    if (!read_scene_name(r, read) || !text_read_hash(r, &read->hash) ||
        !text_read_count(r, "objects", &objects) || !resolved_read_one(r, &read->options, "size") ||
        !read_part(r, &read->options, &read->part) || !read_tier(r, &read->tier) ||
        !resolved_read(r, &read->options) || !read_totals(r, &read->statistics) ||
        !text_next_field(r, "pixels"))
        return false;
    read->objects = objects;
    if (objects > UINT32_MAX)
        return text_wrong(r, "more objects than a scene can have");
    return text_at_end(r, "the pixels on lines of their own");
}

static bool read_pixel(text_fields *r, size_t objects, pixel_record *pixel)
{
    uint64_t object;
    *pixel = (pixel_record){.seen = SURE_MISS};
    if (text_takes(r, "miss"))
        return text_at_end(r, "'miss' alone");
    if (objects == 0 || !text_take_number(r, 10, objects - 1, &object))
        return text_wrong(r, "expected 'miss' or an object's number below %zu", objects);
    int part = take_part(r);
    if (part < 0)
        return text_wrong(r, "expected a part: surface, base, top or wall");
    int stage = take_stage(r);
    if (stage < 0)
        return text_wrong(r, "expected a stage: double, double-double, mod128 or exact");
    if (!text_take_double(r, &pixel->t) || !text_take_double(r, &pixel->t_error))
        return text_wrong(r, "expected t and its error, hexadecimal as 0x1.8p+3");
    pixel->object = (uint32_t)object;
    pixel->seen = SURE_HIT;
    pixel->part = (uint8_t)part;
    pixel->stage = (uint8_t)stage;
    return text_at_end(r, "no more");
}

/* Room that grows with what is read, not with what the header claims. */
static bool make_room(const text_fields *r, certificate *read, size_t count, size_t *room)
{
    if (count < *room)
        return true;
    size_t more = *room > 0 ? 2 * *room : 4096;
    pixel_record *larger = realloc(read->records, more * sizeof *larger);
    if (!larger)
        return text_wrong(r, "no memory");
    read->records = larger;
    *room = more;
    return true;
}

static bool read_pixels(text_fields *r, certificate *read)
{
    size_t room = 0;
    for (size_t i = 0; i < pixel_count(&read->part); i++) {
        if (!text_next_line(r) || !make_room(r, read, i, &room) ||
            !read_pixel(r, read->objects, &read->records[i]))
            return false;
    }
    r->number++;
    return getc(r->file) == EOF || text_wrong(r, "more pixels than the part has");
}

bool certificate_read(const char *path, FILE *messages, certificate *read)
{
    text_fields r = {.path = path, .kind = "certificate", .messages = messages};
    *read = (certificate){.options = rt_default_options()};
    r.file = fopen(path, "rb");
    if (!r.file)
        return complain(messages, path, strerror(errno));
    bool done = read_header(&r, read) && read_pixels(&r, read);
    free(r.line);
    fclose(r.file);
    if (!done)
        certificate_free(read);
    return done;
}
