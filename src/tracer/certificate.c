#define _POSIX_C_SOURCE 200809L /* getline */

#include "certificate.h"

#include "render_file.h"
#include "visible.h"
#include "whole_file.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>

static const char title[] = "surehit certificate 1";

/* The options' words, as rt_set_option takes them. */
static const struct {
    const char *name, *words[3];
} choices[] = {
    {"handedness", {[RT_RIGHT_HANDED] = "right", [RT_LEFT_HANDED] = "left"}},
    {"fov", {[RT_FOV_HORIZONTAL] = "horizontal", [RT_FOV_VERTICAL] = "vertical"}},
    {"cylinder-position", {[RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base"}},
    {"cone-position",
     {[RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base", [RT_POSITION_APEX] = "apex"}},
    {"falloff", {[SURE_FALLOFF_NONE] = "none", [SURE_FALLOFF_INVERSE_SQUARE] = "inverse-square"}},
};

#define CHOICES (sizeof choices / sizeof *choices)

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
        return complain(messages, scene, "a certificate is of a scene in a file");
    FILE *file = fopen(scene, "rb");
    if (!file)
        return complain(messages, scene, strerror(errno));
    unsigned char bytes[65536];
    size_t count;
    *hash = UINT64_C(0xcbf29ce484222325);
    while ((count = fread(bytes, 1, sizeof bytes, file)) > 0) {
        for (size_t i = 0; i < count; i++)
            *hash = (*hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    }
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

static void print_choices(FILE *out, const rt_options *options)
{
    const int meanings[CHOICES] = {(int)options->handedness, (int)options->fov,
                                   (int)options->cylinder_position, (int)options->cone_position,
                                   (int)options->falloff};
    for (size_t i = 0; i < CHOICES; i++)
        fprintf(out, "%s %s\n", choices[i].name, choices[i].words[meanings[i]]);
    fprintf(out, "skip-unknown %s\n", options->skip_unknown ? "yes" : "no");
}

static void print_totals(FILE *out, const sure_account *sum)
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
    print_choices(out, &of->options);
    print_totals(out, &of->account);
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
    whole_file file;
    if (!whole_file_open(path, messages, &file))
        return false;
    print_header(file.stream, of);
    for (size_t i = 0; i < pixel_count(&of->part) && !ferror(file.stream); i++)
        print_pixel(file.stream, &of->records[i]);
    return whole_file_finish(&file, messages);
}

/* Reading, a line at a time. */

typedef struct {
    FILE *file;
    const char *path;
    FILE *messages;
    char *line;      /* without its end */
    size_t capacity; /* of `line` */
    size_t number;   /* the line's; 0: none yet */
    const char *at;  /* what is read next of it */
} reader;

__attribute__((format(printf, 2, 3))) static bool wrong(const reader *r, const char *format, ...)
{
    va_list arguments;
    fprintf(r->messages, "%s:%zu: error: ", r->path, r->number);
    va_start(arguments, format);
    vfprintf(r->messages, format, arguments);
    va_end(arguments);
    fputc('\n', r->messages);
    return false;
}

static bool next_line(reader *r)
{
    ssize_t length = getline(&r->line, &r->capacity, r->file);
    r->number++;
    if (length < 0 && !feof(r->file))
        return wrong(r, "cannot be read: %s", strerror(errno));
    if (length < 0)
        return wrong(r, "the certificate ends too early");
    if (r->line[length - 1] != '\n' || strlen(r->line) != (size_t)length)
        return wrong(r, "no whole line of text");
    r->line[length - 1] = '\0';
    r->at = r->line;
    return true;
}

/* Each of these moves behind what it reads and a blank that follows; false: it is not there. */

static bool is_end(const char *at)
{
    return *at == '\0' || (*at == ' ' && at[1] != '\0');
}

static void move_to(reader *r, const char *end)
{
    r->at = *end == ' ' ? end + 1 : end;
}

static bool takes(reader *r, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(r->at, word, length) != 0 || !is_end(r->at + length))
        return false;
    move_to(r, r->at + length);
    return true;
}

/* Digits of a base, as printf writes them. */
static bool take_number(reader *r, int base, uint64_t most, uint64_t *number)
{
    const char *digits = base == 16 ? "0123456789abcdef" : "0123456789";
    size_t length = strspn(r->at, digits);
    errno = 0;
    uintmax_t value = strtoumax(r->at, NULL, base);
    if (length == 0 || !is_end(r->at + length) || errno != 0 || value > most)
        return false;
    *number = value;
    move_to(r, r->at + length);
    return true;
}

/* A finite number, not negative, in the digits of %a. */
static bool take_double(reader *r, double *number)
{
    char *end;
    if (strncmp(r->at, "0x", 2) != 0)
        return false;
    *number = strtod(r->at, &end);
    if (!is_end(end) || !isfinite(*number))
        return false;
    move_to(r, end);
    return true;
}

/* The part or stage whose name stands next; -1: none. */

static int take_part(reader *r)
{
    for (int part = SURE_PART_WALL; part >= 0; part--) {
        if (takes(r, sure_part_name((sure_part)part)))
            return part;
    }
    return -1;
}

static int take_stage(reader *r)
{
    for (int stage = SURE_STAGES - 1; stage >= 0; stage--) {
        if (takes(r, sure_stage_name((sure_stage)stage)))
            return stage;
    }
    return -1;
}

/* A line that begins with this word. */
static bool next_field(reader *r, const char *name)
{
    if (!next_line(r))
        return false;
    return takes(r, name) || wrong(r, "expected '%s'", name);
}

static bool at_end(const reader *r, const char *expected)
{
    return *r->at == '\0' || wrong(r, "expected %s", expected);
}

/* More of anything is not counted in a lifetime, and sums of counts don't overflow. */
#define COUNT_MOST (UINT64_C(1) << 56)

static bool read_count(reader *r, const char *name, uint64_t *count)
{
    if (!next_field(r, name))
        return false;
    if (!take_number(r, 10, COUNT_MOST, count))
        return wrong(r, "expected a number");
    return at_end(r, "one number");
}

static bool read_hash(reader *r, uint64_t *hash)
{
    if (!next_field(r, "hash"))
        return false;
    return (take_number(r, 16, UINT64_MAX, hash) && *r->at == '\0') ||
           wrong(r, "expected a hexadecimal number");
}

/* The choice's words, as the command line takes them. */
static bool read_option(reader *r, rt_options *options, const char *name)
{
    rt_options_set unused = {0};
    if (!next_field(r, name))
        return false;
    const char *expected = rt_set_option(options, &unused, name, r->at);
    return !expected || wrong(r, "%s '%s': expected %s", name, r->at, expected);
}

static bool read_options(reader *r, rt_options *options)
{
    for (size_t i = 0; i < CHOICES; i++) {
        if (!read_option(r, options, choices[i].name))
            return false;
    }
    if (!next_field(r, "skip-unknown"))
        return false;
    options->skip_unknown = strcmp(r->at, "yes") == 0;
    return options->skip_unknown || strcmp(r->at, "no") == 0 || wrong(r, "expected 'yes' or 'no'");
}

static bool fits(int begin, int length, int whole)
{
    return begin <= whole && length <= whole - begin;
}

static bool read_part(reader *r, const rt_options *whole, picture_part *part)
{
    if (!next_field(r, "part"))
        return false;
    return (render_part_from(r->at, part) && fits(part->x, part->width, whole->width) &&
            fits(part->y, part->height, whole->height)) ||
           wrong(r, "expected a part of the picture, X,Y,WxH");
}

static bool read_tier(reader *r, sure_tier *tier)
{
    if (!next_field(r, "tier"))
        return false;
    return (sure_tier_from_name(r->at, tier) && is_sure(*tier)) ||
           wrong(r, "expected 'certain' or 'exact'");
}

/* A line of counts, each behind its name. */
static bool read_counts(reader *r, const char *field, const char *const *names, int count,
                        uint64_t *counts)
{
    if (!next_field(r, field))
        return false;
    for (int i = 0; i < count; i++) {
        if (!takes(r, names[i]) || !take_number(r, 10, COUNT_MOST, &counts[i]))
            return wrong(r, "expected '%s' and a number", names[i]);
    }
    return at_end(r, "no more");
}

static bool read_totals(reader *r, sure_account *sum)
{
    const char *kinds[SURE_RAY_KINDS], *stages[SURE_STAGES];
    for (int i = 0; i < SURE_RAY_KINDS; i++)
        kinds[i] = sure_ray_kind_name((sure_ray_kind)i);
    for (int i = 0; i < SURE_STAGES; i++)
        stages[i] = sure_stage_name((sure_stage)i);
    return read_counts(r, "rays", kinds, SURE_RAY_KINDS, sum->rays) &&
           read_counts(r, "hits", stages, SURE_STAGES, sum->decided) &&
           read_count(r, "misses", &sum->missed) && read_count(r, "origins", &sum->origins) &&
           read_count(r, "without-origin", &sum->without_origin) &&
           read_count(r, "covered", &sum->covered) && read_count(r, "acne", &sum->acne);
}

static bool read_scene_name(reader *r, certificate *read)
{
    if (!next_field(r, "scene"))
        return false;
    read->scene = strdup(r->at);
    return read->scene || wrong(r, "no memory");
}

static bool read_header(reader *r, certificate *read)
{
    uint64_t objects;
    if (!next_line(r))
        return false;
    if (strcmp(r->line, title) != 0)
        return wrong(r, "expected '%s'", title);
    if (!read_scene_name(r, read) || !read_hash(r, &read->hash) ||
        !read_count(r, "objects", &objects) || !read_option(r, &read->options, "size") ||
        !read_part(r, &read->options, &read->part) || !read_tier(r, &read->tier) ||
        !read_options(r, &read->options) || !read_totals(r, &read->account) ||
        !next_field(r, "pixels"))
        return false;
    read->objects = objects;
    if (objects > UINT32_MAX)
        return wrong(r, "more objects than a scene can have");
    return at_end(r, "the pixels on lines of their own");
}

static bool read_pixel(reader *r, size_t objects, pixel_record *pixel)
{
    uint64_t object;
    *pixel = (pixel_record){.seen = SURE_MISS};
    if (takes(r, "miss"))
        return at_end(r, "'miss' alone");
    if (objects == 0 || !take_number(r, 10, objects - 1, &object))
        return wrong(r, "expected 'miss' or an object's number below %zu", objects);
    int part = take_part(r);
    if (part < 0)
        return wrong(r, "expected a part: surface, base, top or wall");
    int stage = take_stage(r);
    if (stage < 0)
        return wrong(r, "expected a stage: double, double-double, residue or exact");
    if (!take_double(r, &pixel->t) || !take_double(r, &pixel->t_error))
        return wrong(r, "expected t and its error, hexadecimal as 0x1.8p+3");
    pixel->object = (uint32_t)object;
    pixel->seen = SURE_HIT;
    pixel->part = (uint8_t)part;
    pixel->stage = (uint8_t)stage;
    return at_end(r, "no more");
}

/* Room that grows with what is read, not with what the header claims. */
static bool make_room(const reader *r, certificate *read, size_t count, size_t *room)
{
    if (count < *room)
        return true;
    size_t more = *room > 0 ? 2 * *room : 4096;
    pixel_record *larger = realloc(read->records, more * sizeof *larger);
    if (!larger)
        return wrong(r, "no memory");
    read->records = larger;
    *room = more;
    return true;
}

static bool read_pixels(reader *r, certificate *read)
{
    size_t room = 0;
    for (size_t i = 0; i < pixel_count(&read->part); i++) {
        if (!next_line(r) || !make_room(r, read, i, &room) ||
            !read_pixel(r, read->objects, &read->records[i]))
            return false;
    }
    r->number++;
    return getc(r->file) == EOF || wrong(r, "more pixels than the part has");
}

bool certificate_read(const char *path, FILE *messages, certificate *read)
{
    reader r = {.path = path, .messages = messages};
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
