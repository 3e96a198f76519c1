/* SPDX-License-Identifier: MIT */
/* A partial film, a share of a picture's photons: their exact sums, in a file that adds to others.
 *
 * The file is compressed as by gzip. It begins with a line of JSON:
 *
 *     {"surehit share": 1, "hash": "0123456789abcdef", "tier": "certain",
 *      "options": {"size": "320x180", "handedness": "right", ... "skip-unknown": false},
 *      "seed": "0000000000000000", "bounces": 1, "aperture": 0.0,
 *      "ranges": [[0, 1000], [5000, 200]],
 *      "counts": {"photons": 1200, "escaped": 500, "absorbed": 700, "stopped": 0, "entered": 0,
 *                 "lit": 700, "through": 300, "reached": 200}}
 *
 * Ranges are of photons, each the first one and how many. The pixels follow in reading order, for
 * each its sums of red, green and blue and of their squares, in steps of 2^-32: sixteen bytes each,
 * the lowest first. Of one set of sums there is one file. */
#pragma once

#include "film.h"
#include "../scene/rt.h"
#include "../support/pieces/ranges.h"

#include <surehit/forward.h>

typedef struct {
    uint64_t hash;      /* of the scene's bytes (rt.h) */
    rt_options options; /* as resolved */
    sure_tier tier;
    sure_forward_options how;
    index_ranges ranges; /* of photons */
    sure_forward_statistics statistics;
    film sums;
} partial_film;

/* One without photons, for those that differ in nothing from `like`. False when there is no memory,
 * with nothing left allocated. */
bool partial_film_begin(const partial_film *like, partial_film *empty);

void partial_film_free(partial_film *of);

/* The file appears whole or not at all. On false one line was written to `messages`. */
bool partial_film_write(const partial_film *of, const char *path, FILE *messages);

/* Reads one (free it with partial_film_free). On false one line was written to `messages`, and
 * nothing is left allocated. */
bool partial_film_read(const char *path, FILE *messages, partial_film *read);

/* The same with open files, which are closed. False where the file can't be written; what is wrong,
 * or NULL. */
bool partial_film_put(const partial_film *of, int file);
const char *partial_film_get(int file, partial_film *read);

/* Makes the picture (free it with picture_free). False after a line about `name` to `messages`. */
bool partial_film_picture(const partial_film *of, const char *name, FILE *messages, picture *image);

/* What keeps them from being added, "seed" for one; NULL: nothing does. */
const char *partial_film_difference(const partial_film *a, const partial_film *b);

/* The sum, of shares that differ in nothing and have no photon in common. False when there is no
 * memory; *to may then have some of it. */
bool partial_film_add(partial_film *to, const partial_film *from);

/* Reads the files and makes their sum (free it with partial_film_free, whatever is returned). False
 * after a line to `messages`: one can't be read, is of another scene or other settings, or has
 * photons that are in another one; or there is no memory. */
bool merge_partial_films(const char *const *paths, int count, FILE *messages, partial_film *sum);

/* Seconds that all of the photons take, where they are not known. */
#define PHOTONS_UNTIMED (-1.0)

/* Counts, and a pixel's variance, which is given in seconds, too. */
void photons_print(FILE *out, const partial_film *of, double seconds);

/* The same for programs; NULL when there is no memory. */
json_t *photons_json(const partial_film *of, double seconds);

/* "0 to 999, 2000 to 2999" */
void photons_print_ranges(FILE *out, const partial_film *of);
