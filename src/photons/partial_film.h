/* A partial film, a share of a picture's photons: their exact sums, in a file that adds to others.
 *
 * The file begins with lines of text, of which the first says what it is:
 *
 *     surehit share 1
 *     scene tests/scenes/default.rt
 *     hash 0123456789abcdef
 *     size 320x180
 *     tier certain
 *     handedness right                     and the other resolved options, a line each
 *     seed 0
 *     bounces 1
 *     aperture 0x0p+0
 *     ranges 2                             so many lines with a first photon and how many
 *     photons 0 1000
 *     photons 5000 200
 *     ended escaped 500 absorbed 700 stopped 0 entered 0
 *     light lit 700 through 300 reached 200
 *     pixels
 *
 * Numbers follow. A number is a byte that says how many bytes of it come, 0 to 16, and these, the
 * lowest first and the last not 0. The pixels are in reading order: the number of dark ones that
 * are passed over, then six numbers of one that is not dark, its sums of red, green and blue and of
 * their squares in steps of 2^-32; and so on until all pixels are counted, the last time without
 * the six where the last pixel is dark. Eight bytes end the file: the hash (FNV-1a, 64 bits, lowest
 * byte first) of all before them. Of one set of sums there is one file. */
#ifndef PHOTONS_PARTIAL_FILM_H
#define PHOTONS_PARTIAL_FILM_H

#include "film.h"
#include "../scene/rt.h"

#include <surehit/forward.h>

/* Photons first .. end - 1. */
typedef struct {
    uint64_t first, end;
} photon_range;

/* Photons have numbers below this. */
#define PHOTONS_MOST (UINT64_C(1) << 56)

typedef struct {
    char *scene;        /* its path as given, printable */
    uint64_t hash;      /* of its bytes: certificate_hash */
    rt_options options; /* as resolved */
    sure_tier tier;
    sure_forward_options how;
    photon_range *ranges; /* in order, apart from one another */
    size_t range_count;
    sure_forward_statistics statistics;
    film sums;
} partial_film;

/* One without photons, for those that differ in nothing from `like`. False when there is no memory,
 * with nothing left allocated. */
bool partial_film_begin(const partial_film *like, partial_film *empty);

void partial_film_free(partial_film *of);

/* The file appears whole or not at all. On false one line was written to `messages`. */
bool partial_film_write(const partial_film *of, const char *path, FILE *messages);

/* Reads one (free it with partial_film_free). A file is read to its end before room for its picture
 * is taken; so it has to be one that can be read twice. On false one line was written to
 * `messages`, which says where the file is wrong, and nothing is left allocated. */
bool partial_film_read(const char *path, FILE *messages, partial_film *read);

/* What keeps them from being added, "seed" for one; NULL: nothing does. */
const char *partial_film_difference(const partial_film *a, const partial_film *b);

/* Photons that are in both: the first such range. */
bool partial_film_overlap(const partial_film *a, const partial_film *b, photon_range *both);

/* Photons are in the sums now that were not, of a range that is not empty. False when there is no
 * memory. */
bool partial_film_add_range(partial_film *to, photon_range more);

/* The sum, of shares that differ in nothing and have no photon in common. Of the scene's names it
 * keeps the first in the alphabet, so that order does not matter. False when there is no memory;
 * *to may then have some of it. */
bool partial_film_add(partial_film *to, const partial_film *from);

/* The first photons of a range that are missing; false: none is. */
bool partial_film_gap(const partial_film *of, photon_range wanted, photon_range *gap);

#endif
