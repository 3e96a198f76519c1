#define _POSIX_C_SOURCE 200809L /* strdup, fseeko */

#include "partial_film.h"

#include "../support/fnv.h"
#include "../scene/resolved.h"
#include "../support/text_fields.h"
#include "../support/atomic_file.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

static const char title[] = "surehit share 1";

#define SUMS 6 /* of a pixel */

static bool complain(FILE *messages, const char *path, const char *what)
{
    fprintf(messages, "%s: error: %s\n", path, what);
    return false;
}

void partial_film_free(partial_film *of)
{
    free(of->scene);
    free(of->ranges);
    film_free(&of->sums);
    *of = (partial_film){0};
}

bool partial_film_begin(const partial_film *like, partial_film *empty)
{
    *empty = (partial_film){
        .scene = strdup(like->scene),
        .hash = like->hash,
        .options = like->options,
        .tier = like->tier,
        .how = like->how,
    };
    if (empty->scene && film_new(like->options.width, like->options.height, &empty->sums))
        return true;
    partial_film_free(empty);
    return false;
}

static size_t pixel_count(const partial_film *of)
{
    return (size_t)of->options.width * (size_t)of->options.height;
}

/* The sums of a pixel, in the file's order. */
static film_sum *sum_of(film_pixel *pixel, int i)
{
    return i < SUMS / 2 ? &pixel->value[i] : &pixel->square[i - SUMS / 2];
}

/* Writing. */

static const char *const ends[] = {"escaped", "absorbed", "stopped", "entered"};
static const char *const lights[] = {"lit", "through", "reached"};
#define ENDS (int)(sizeof ends / sizeof *ends)
#define LIGHTS (int)(sizeof lights / sizeof *lights)

typedef struct {
    FILE *stream;
    uint64_t hash; /* of what was written */
} writer;

static void put(writer *w, const void *bytes, size_t count)
{
    fwrite(bytes, 1, count, w->stream);
    w->hash = fnv_add(w->hash, bytes, count);
}

static void print_statistics(FILE *out, const sure_forward_statistics *statistics)
{
    fprintf(out,
            "ended escaped %" PRIu64 " absorbed %" PRIu64 " stopped %" PRIu64 " entered %" PRIu64
            "\nlight lit %" PRIu64 " through %" PRIu64 " reached %" PRIu64 "\n",
            statistics->escaped, statistics->absorbed, statistics->stopped, statistics->entered,
            statistics->lit, statistics->through, statistics->reached);
}

static void print_header(FILE *out, const partial_film *of)
{
    fprintf(out, "%s\nscene %s\nhash %016" PRIx64 "\nsize %dx%d\ntier %s\n", title, of->scene,
            of->hash, of->options.width, of->options.height, sure_tier_name(of->tier));
    resolved_print(out, &of->options);
    fprintf(out, "seed %" PRIu64 "\nbounces %d\naperture %a\nranges %zu\n", of->how.seed,
            of->how.bounces, of->how.aperture, of->range_count);
    for (size_t i = 0; i < of->range_count; i++)
        fprintf(out, "photons %" PRIu64 " %" PRIu64 "\n", of->ranges[i].first,
                of->ranges[i].end - of->ranges[i].first);
    print_statistics(out, &of->statistics);
    fputs("pixels\n", out);
}

/* In memory first, where it can be hashed. */
static bool put_header(writer *w, const partial_film *of)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return false;
    print_header(out, of);
    bool printed = fclose(out) == 0;
    if (printed)
        put(w, text, size);
    free(text);
    return printed;
}

static void put_number(writer *w, film_sum number)
{
    uint8_t bytes[17] = {0};
    for (int i = 0; i < 16; i++) {
        bytes[1 + i] = (uint8_t)((i < 8 ? number.low : number.high) >> (8 * (i % 8)));
        if (bytes[1 + i] != 0)
            bytes[0] = (uint8_t)(i + 1);
    }
    put(w, bytes, 1 + (size_t)bytes[0]);
}

static bool is_dark(film_pixel *pixel)
{
    uint64_t any = 0;
    for (int i = 0; i < SUMS; i++)
        any |= sum_of(pixel, i)->low | sum_of(pixel, i)->high;
    return any == 0;
}

static void put_pixels(writer *w, const partial_film *of)
{
    uint64_t dark = 0;
    for (size_t i = 0; i < pixel_count(of) && !ferror(w->stream); i++) {
        film_pixel *pixel = &of->sums.pixels[i];
        if (is_dark(pixel)) {
            dark++;
            continue;
        }
        put_number(w, (film_sum){dark, 0});
        for (int j = 0; j < SUMS; j++)
            put_number(w, *sum_of(pixel, j));
        dark = 0;
    }
    if (dark > 0)
        put_number(w, (film_sum){dark, 0});
}

static void put_hash(writer *w)
{
    uint8_t bytes[8];
    for (int i = 0; i < 8; i++)
        bytes[i] = (uint8_t)(w->hash >> (8 * i));
    put(w, bytes, sizeof bytes);
}

bool partial_film_write(const partial_film *of, const char *path, FILE *messages)
{
    atomic_file file;
    if (!atomic_file_open(path, messages, &file))
        return false;
    writer w = {file.stream, FNV_START};
    if (!put_header(&w, of)) {
        atomic_file_discard(&file);
        return complain(messages, path, "no memory");
    }
    put_pixels(&w, of);
    put_hash(&w);
    return atomic_file_finish(&file, messages);
}

/* Reading the header. */

static bool read_ranges(text_fields *r, partial_film *read, uint64_t *photons)
{
    uint64_t count, first, number;
    if (!text_read_count(r, "ranges", &count))
        return false;
    if (count == 0)
        return text_wrong(r, "no photons at all");
    for (uint64_t i = 0; i < count; i++) {
        if (!text_next_field(r, "photons"))
            return false;
        if (!text_take_number(r, 10, PHOTONS_MOST, &first) ||
            !text_take_number(r, 10, PHOTONS_MOST - first, &number) || number == 0)
            return text_wrong(r, "expected the first photon and how many");
        if (read->range_count > 0 && first <= read->ranges[read->range_count - 1].end)
            return text_wrong(r, "photons that don't lie behind those before");
        if (!partial_film_add_range(read, (photon_range){first, first + number}))
            return text_wrong(r, "no memory");
        *photons += number;
        if (!text_at_end(r, "two numbers"))
            return false;
    }
    return true;
}

/* Every photon ends once; what reaches the eye has passed the window, from a point that was lit or
 * on a photon's own way. */
static bool read_statistics(text_fields *r, uint64_t photons, sure_forward_statistics *statistics)
{
    uint64_t ended[ENDS], light[LIGHTS], left = photons;
    if (!text_read_counts(r, "ended", ends, ENDS, ended))
        return false;
    for (int i = 0; i < ENDS; i++) {
        if (ended[i] > left)
            return text_wrong(r, "more photons have ended than have left");
        left -= ended[i];
    }
    if (left > 0)
        return text_wrong(r, "fewer photons have ended than have left");
    if (!text_read_counts(r, "light", lights, LIGHTS, light))
        return false;
    if (light[2] > light[1])
        return text_wrong(r, "more has reached the eye than has passed the view plane");
    *statistics = (sure_forward_statistics){photons,  ended[0], ended[1], ended[2],
                                            ended[3], light[0], light[1], light[2]};
    return true;
}

static bool read_number(text_fields *r, const char *name, uint64_t least, uint64_t most,
                        uint64_t *number)
{
    if (!text_next_field(r, name))
        return false;
    return (text_take_number(r, 10, most, number) && *number >= least && *r->at == '\0') ||
           text_wrong(r, "expected a number of %s", name);
}

static bool read_how(text_fields *r, sure_forward_options *how)
{
    uint64_t bounces;
    if (!read_number(r, "seed", 0, UINT64_MAX, &how->seed) ||
        !read_number(r, "bounces", 1, INT_MAX, &bounces) || !text_next_field(r, "aperture"))
        return false;
    how->bounces = (int)bounces;
    return (text_take_double(r, &how->aperture) && *r->at == '\0') ||
           text_wrong(r, "expected a radius, hexadecimal as 0x1.8p+3");
}

static bool read_tier(text_fields *r, sure_tier *tier)
{
    if (!text_next_field(r, "tier"))
        return false;
    return sure_tier_from_name(r->at, tier) || text_wrong(r, "expected a tier's name");
}

static bool read_scene(text_fields *r, partial_film *read)
{
    if (!text_next_field(r, "scene"))
        return false;
    read->scene = strdup(r->at);
    return read->scene || text_wrong(r, "no memory");
}

static bool read_header(text_fields *r, partial_film *read)
{
    uint64_t photons = 0;
    if (!text_next_line(r))
        return false;
    if (strcmp(r->line, title) != 0)
        return text_wrong(r, "expected '%s'", title);
    return read_scene(r, read) && text_read_hash(r, &read->hash) &&
           resolved_read_one(r, &read->options, "size") && read_tier(r, &read->tier) &&
           resolved_read(r, &read->options) && read_how(r, &read->how) &&
           read_ranges(r, read, &photons) && read_statistics(r, photons, &read->statistics) &&
           text_next_field(r, "pixels") && text_at_end(r, "the pixels behind this line");
}

/* Reading the pixels. */

typedef struct {
    FILE *file;
    const char *path;
    FILE *messages;
    uint64_t hash;   /* of what was read */
    uint64_t offset; /* of what is read next */
} reader;

static bool wrong(const reader *r, const char *what)
{
    fprintf(r->messages, "%s: error: byte %" PRIu64 ": %s\n", r->path, r->offset, what);
    return false;
}

static bool get(reader *r, uint8_t *bytes, size_t count)
{
    size_t got = fread(bytes, 1, count, r->file);
    if (got == count) {
        r->hash = fnv_add(r->hash, bytes, count);
        r->offset += count;
        return true;
    }
    int error = errno;
    r->offset += got;
    return wrong(r, ferror(r->file) ? strerror(error) : "the share ends too early");
}

static bool get_number(reader *r, film_sum *number)
{
    uint8_t length, bytes[16] = {0};
    if (!get(r, &length, 1))
        return false;
    if (length > sizeof bytes)
        return wrong(r, "a number of more than 16 bytes");
    if (length > 0 && !get(r, bytes, length))
        return false;
    if (length > 0 && bytes[length - 1] == 0)
        return wrong(r, "a number with a byte too many");
    *number = (film_sum){0, 0};
    for (int i = 0; i < 8; i++) {
        number->low |= (uint64_t)bytes[i] << (8 * i);
        number->high |= (uint64_t)bytes[8 + i] << (8 * i);
    }
    return true;
}

static bool get_pixel(reader *r, film_pixel *pixel)
{
    for (int i = 0; i < SUMS; i++) {
        if (!get_number(r, sum_of(pixel, i)))
            return false;
    }
    return !is_dark(pixel) || wrong(r, "a dark pixel among those that are not");
}

/* To `pixels`, which are dark, or nowhere (NULL). */
static bool get_pixels(reader *r, size_t count, film_pixel *pixels)
{
    for (size_t i = 0; i < count; i++) {
        film_sum dark;
        film_pixel pixel;
        if (!get_number(r, &dark))
            return false;
        if (dark.high > 0 || dark.low > count - i)
            return wrong(r, "more pixels than the picture has");
        i += (size_t)dark.low;
        if (i == count)
            break;
        if (!get_pixel(r, &pixel))
            return false;
        if (pixels)
            pixels[i] = pixel;
    }
    return true;
}

static bool check_hash(reader *r)
{
    uint64_t hash = r->hash, written = 0;
    uint8_t bytes[8];
    if (!get(r, bytes, sizeof bytes))
        return false;
    for (int i = 0; i < 8; i++)
        written |= (uint64_t)bytes[i] << (8 * i);
    if (written != hash)
        return wrong(r, "the hash is another one: the share was damaged");
    return getc(r->file) == EOF || wrong(r, "something follows where the share ends");
}

/* From behind the header, first to see whether all of it is right, then to have it. */
static bool get_film(reader *r, partial_film *read)
{
    reader again = *r;
    const rt_options *options = &read->options;
    if (!get_pixels(r, pixel_count(read), NULL) || !check_hash(r))
        return false;
    if (!film_new(options->width, options->height, &read->sums))
        return complain(r->messages, r->path, "no memory for its picture");
    if (fseeko(r->file, (off_t)again.offset, SEEK_SET) != 0)
        return complain(r->messages, r->path, "cannot be read twice");
    *r = again;
    return get_pixels(r, pixel_count(read), read->sums.pixels) && check_hash(r);
}

static bool read_all(FILE *file, const char *path, FILE *messages, partial_film *read)
{
    text_fields header = {
        .file = file, .path = path, .kind = "share", .messages = messages, .hash = FNV_START};
    bool done = read_header(&header, read);
    free(header.line);
    if (!done)
        return false;
    off_t offset = ftello(file);
    if (offset < 0)
        return complain(messages, path, "cannot be read twice");
    return get_film(&(reader){file, path, messages, header.hash, (uint64_t)offset}, read);
}

bool partial_film_read(const char *path, FILE *messages, partial_film *read)
{
    *read = (partial_film){.options = rt_default_options()};
    FILE *file = fopen(path, "rb");
    if (!file)
        return complain(messages, path, strerror(errno));
    bool done = read_all(file, path, messages, read);
    fclose(file);
    if (!done)
        partial_film_free(read);
    return done;
}

/* Adding. */

const char *partial_film_difference(const partial_film *a, const partial_film *b)
{
    if (a->hash != b->hash)
        return "scene";
    if (a->tier != b->tier)
        return "tier";
    if (a->how.seed != b->how.seed)
        return "seed";
    if (a->how.bounces != b->how.bounces)
        return "bounces";
    if (a->how.aperture != b->how.aperture)
        return "aperture";
    return resolved_difference(&a->options, &b->options);
}

bool partial_film_overlap(const partial_film *a, const partial_film *b, photon_range *both)
{
    for (size_t i = 0, j = 0; i < a->range_count && j < b->range_count;) {
        const photon_range *of_a = &a->ranges[i], *of_b = &b->ranges[j];
        both->first = of_a->first > of_b->first ? of_a->first : of_b->first;
        both->end = of_a->end < of_b->end ? of_a->end : of_b->end;
        if (both->first < both->end)
            return true;
        if (of_a->end < of_b->end)
            i++;
        else
            j++;
    }
    return false;
}

/* Joins the range at `i` with the next one where they touch. */
static void join(partial_film *of, size_t i)
{
    if (i + 1 >= of->range_count || of->ranges[i].end != of->ranges[i + 1].first)
        return;
    of->ranges[i].end = of->ranges[i + 1].end;
    of->range_count--;
    memmove(&of->ranges[i + 1], &of->ranges[i + 2], (of->range_count - i - 1) * sizeof *of->ranges);
}

bool partial_film_add_range(partial_film *to, photon_range more)
{
    size_t count = to->range_count, at = count;
    photon_range *larger = realloc(to->ranges, (count + 1) * sizeof *larger);
    if (!larger)
        return false;
    while (at > 0 && larger[at - 1].first > more.first)
        at--;
    memmove(&larger[at + 1], &larger[at], (count - at) * sizeof *larger);
    larger[at] = more;
    to->ranges = larger;
    to->range_count++;
    join(to, at);
    if (at > 0)
        join(to, at - 1);
    return true;
}

static bool add_name(partial_film *to, const partial_film *from)
{
    if (strcmp(to->scene, from->scene) <= 0)
        return true;
    char *name = strdup(from->scene);
    if (!name)
        return false;
    free(to->scene);
    to->scene = name;
    return true;
}

bool partial_film_add(partial_film *to, const partial_film *from)
{
    if (!add_name(to, from))
        return false;
    for (size_t i = 0; i < from->range_count; i++) {
        if (!partial_film_add_range(to, from->ranges[i]))
            return false;
    }
    sure_forward_statistics_add(&to->statistics, &from->statistics);
    film_merge(&to->sums, &from->sums);
    return true;
}

bool partial_film_gap(const partial_film *of, photon_range wanted, photon_range *gap)
{
    *gap = wanted;
    for (size_t i = 0; i < of->range_count; i++) {
        const photon_range *there = &of->ranges[i];
        if (there->first <= gap->first && gap->first < there->end)
            gap->first = there->end;
        if (gap->first < there->first && there->first < gap->end)
            gap->end = there->first;
    }
    return gap->first < gap->end;
}
