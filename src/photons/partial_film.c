/* SPDX-License-Identifier: MIT */
#include "partial_film.h"

#include "../support/atomic_file.h"
#include "../support/complain.h"
#include "../support/json_file.h"
#include "unpacking.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define FORMAT 1
#define PIXEL 96 /* bytes */

void partial_film_free(partial_film *of)
{
    free(of->ranges.of);
    film_free(&of->sums);
    *of = (partial_film){0};
}

bool partial_film_begin(const partial_film *like, partial_film *empty)
{
    *empty = (partial_film){
        .hash = like->hash, .options = like->options, .tier = like->tier, .how = like->how};
    return film_new(like->options.width, like->options.height, &empty->sums);
}

static size_t pixel_count(const partial_film *of)
{
    return (size_t)of->options.width * (size_t)of->options.height;
}

/* What became of the photons. */

/* As they stand in sure_forward_statistics. */
static const struct {
    const char *name, *words;
} rows[] = {
    {"photons", "photons left"},          {"escaped", "  escaped"},
    {"absorbed", "  absorbed"},           {"stopped", "  stopped"},
    {"entered", "  entered the opening"}, {"lit", "points lit"},
    {"through", "passed the view plane"}, {"reached", "reached the eye"},
};

#define COUNTS (int)(sizeof rows / sizeof *rows)
_Static_assert(sizeof(sure_forward_statistics) == COUNTS * sizeof(uint64_t), "a row a count");

static const char *name_of(int i)
{
    return rows[i].name;
}

/* Every photon ends once; what reaches the eye has passed the window, from a point that was lit or
 * on a photon's own way. Returns what is wrong, or NULL. */
static const char *take_counts(const json_t *object, uint64_t photons, sure_forward_statistics *sum)
{
    if (!json_take_named_counts(object, name_of, &sum->emitted, COUNTS))
        return "expected what became of the photons";
    if (sum->emitted != photons)
        return "the counts are of other photons";
    if (sum->escaped + sum->absorbed + sum->stopped + sum->entered != photons)
        return "not every photon has ended once";
    return sum->reached <= sum->through ? NULL
                                        : "more has reached the eye than has passed the view plane";
}

void photons_print(FILE *out, const partial_film *of, double seconds)
{
    const uint64_t photons = of->statistics.emitted;
    double variance = film_variance(&of->sums, photons);
    for (int i = 0; i < COUNTS; i++) {
        uint64_t count = (&of->statistics.emitted)[i];
        fprintf(out, "%-22s %12" PRIu64, rows[i].words, count);
        if (i > 0)
            fprintf(out, " %12.1f per million", 1e6 * (double)count / (double)photons);
        fputc('\n', out);
    }
    fprintf(out, "variance of a pixel's mean %.4g", variance);
    if (seconds >= 0)
        fprintf(out, ", times %.2f s: %.4g s", seconds, variance * seconds);
    fputc('\n', out);
}

json_t *photons_json(const partial_film *of, double seconds)
{
    double variance = film_variance(&of->sums, of->statistics.emitted);
    json_t *object = json_named_counts(name_of, &of->statistics.emitted, COUNTS);
    json_object_set_new(object, "variance", json_measured(variance));
    json_object_set_new(object, "variance_seconds",
                        json_measured(seconds >= 0 ? variance * seconds : INFINITY));
    return object;
}

void photons_print_ranges(FILE *out, const partial_film *of)
{
    for (size_t i = 0; i < of->ranges.count; i++)
        fprintf(out, "%s%" PRIu64 " to %" PRIu64, i > 0 ? ", " : "", of->ranges.of[i].first,
                of->ranges.of[i].end - 1);
}

bool partial_film_picture(const partial_film *of, const char *name, FILE *messages, picture *image)
{
    return film_picture_new(&of->sums, of->statistics.emitted, image) ||
           complain(messages, name, "no memory for this picture");
}

/* Writing. */

static json_t *header_json(const partial_film *of)
{
    return json_pack("{s:i, s:o, s:s, s:o, s:o, s:i, s:f, s:o, s:o}", "surehit share", FORMAT,
                     "hash", json_bits(of->hash), "tier", sure_tier_name(of->tier), "options",
                     rt_options_json(&of->options), "seed", json_bits(of->how.seed), "bounces",
                     of->how.bounces, "aperture", of->how.aperture, "ranges",
                     ranges_json(&of->ranges), "counts",
                     json_named_counts(name_of, &of->statistics.emitted, COUNTS));
}

static bool put_header(gzFile to, const partial_film *of)
{
    json_t *header = header_json(of);
    char *text = json_dumps(header, JSON_REAL_PRECISION(17));
    bool put = text && gzputs(to, text) >= 0 && gzputc(to, '\n') == '\n';
    json_decref(header);
    free(text);
    return put;
}

/* The sum of a pixel that its byte is of, in the file's order. */
static film_sum *sum_of(film_pixel *pixel, int byte)
{
    int i = byte / 16;
    return i < 3 ? &pixel->value[i] : &pixel->square[i - 3];
}

static bool put_pixels(gzFile to, const partial_film *of)
{
    for (size_t i = 0; i < pixel_count(of); i++) {
        uint8_t bytes[PIXEL];
        for (int j = 0; j < PIXEL; j++)
            bytes[j] = (uint8_t)(*sum_of(&of->sums.pixels[i], j) >> 8 * (j % 16));
        if (gzwrite(to, bytes, PIXEL) != PIXEL)
            return false;
    }
    return true;
}

bool partial_film_put(const partial_film *of, int file)
{
    gzFile to = gzdopen(file, "wb1");
    bool put = to && put_header(to, of) && put_pixels(to, of);
    return gzclose(to) == Z_OK && put;
}

bool partial_film_write(const partial_film *of, const char *path, FILE *messages)
{
    atomic_file file;
    if (!atomic_file_open(path, messages, &file))
        return false;
    errno = 0;
    if (partial_film_put(of, dup(fileno(file.stream))))
        return atomic_file_finish(&file, messages);
    complain(messages, path, "%s", errno != 0 ? strerror(errno) : "no memory");
    atomic_file_discard(&file);
    return false;
}

/* Reading. */

static const char *take_header(json_t *header, partial_film *read)
{
    static char reason[JSON_ERROR_TEXT_LENGTH];
    json_error_t error;
    json_t *hash, *seed, *options, *ranges, *counts;
    const char *tier;
    json_int_t format, bounces;
    if (json_unpack_ex(header, &error, 0, "{s:I, s:o, s:s, s:o, s:o, s:I, s:F, s:o, s:o!}",
                       "surehit share", &format, "hash", &hash, "tier", &tier, "options", &options,
                       "seed", &seed, "bounces", &bounces, "aperture", &read->how.aperture,
                       "ranges", &ranges, "counts", &counts) != 0)
        return strcpy(reason, error.text);
    if (format != FORMAT)
        return "another format";
    if (!json_take_bits(hash, &read->hash) || !json_take_bits(seed, &read->how.seed))
        return "expected 16 hexadecimal digits for hash and seed";
    if (!sure_tier_from_name(tier, &read->tier))
        return "expected a tier's name";
    if (bounces < 1 || bounces > INT_MAX || !(read->how.aperture >= 0))
        return "expected bounces from 1 on, and a radius";
    read->how.bounces = (int)bounces;
    const char *wrong = rt_options_from_json(options, &read->options);
    if (!wrong)
        wrong = ranges_take(ranges, &read->ranges);
    return wrong ? wrong : take_counts(counts, ranges_total(&read->ranges), &read->statistics);
}

/* For jansson, a character at a time: what stands behind the header is not for it. */
static size_t next_character(void *to, size_t size, void *from)
{
    int c = size > 0 ? unpacking_next(from) : EOF;
    *(char *)to = (char)c;
    return c != EOF;
}

static const char *get_header(unpacking *from, partial_film *read)
{
    json_error_t error;
    json_t *header = json_load_callback(next_character, from,
                                        JSON_DISABLE_EOF_CHECK | JSON_REJECT_DUPLICATES, &error);
    if (!header)
        return json_error_code(&error) == json_error_duplicate_key
                   ? "a name stands twice in its header"
                   : "this is no share";
    const char *wrong = take_header(header, read);
    json_decref(header);
    return wrong || unpacking_next(from) == '\n' ? wrong : "more than a header in its line";
}

static const char *get_pixels(unpacking *from, partial_film *read)
{
    static const char damaged[] = "the share ends too early, or is damaged";
    for (size_t i = 0; i < pixel_count(read); i++) {
        uint8_t bytes[PIXEL];
        if (unpacking_get(from, bytes, PIXEL) != PIXEL)
            return damaged;
        for (int j = 0; j < PIXEL; j++)
            *sum_of(&read->sums.pixels[i], j) |= (film_sum)bytes[j] << 8 * (j % 16);
    }
    if (unpacking_follows(from))
        return "something follows where the share ends";
    return from->state == Z_STREAM_END ? NULL : damaged;
}

static const char *get_share(unpacking *from, partial_film *read)
{
    const char *wrong = get_header(from, read);
    if (!wrong && !film_new(read->options.width, read->options.height, &read->sums))
        wrong = "no memory for its picture";
    if (!wrong)
        wrong = get_pixels(from, read);
    return from->error != 0 ? strerror(from->error) : wrong;
}

const char *partial_film_get(int file, partial_film *read)
{
    unpacking from;
    *read = (partial_film){.options = rt_default_options()};
    if (file < 0)
        return strerror(errno);
    bool begun = unpacking_begin(file, &from);
    const char *wrong = begun ? get_share(&from, read) : "no memory";
    if (begun)
        unpacking_end(&from);
    close(file);
    if (wrong)
        partial_film_free(read);
    return wrong;
}

bool partial_film_read(const char *path, FILE *messages, partial_film *read)
{
    const char *wrong = partial_film_get(open(path, O_RDONLY | O_CLOEXEC), read);
    return !wrong || complain(messages, path, "%s", wrong);
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
    return rt_options_difference(&a->options, &b->options);
}

bool partial_film_add(partial_film *to, const partial_film *from)
{
    for (size_t i = 0; i < from->ranges.count; i++) {
        if (!ranges_add(&to->ranges, from->ranges.of[i]))
            return false;
    }
    sure_forward_statistics_add(&to->statistics, &from->statistics);
    film_merge(&to->sums, &from->sums);
    return true;
}
