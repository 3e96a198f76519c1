/* Shares of one scene's photons added up. */
#ifndef PHOTONS_MERGE_H
#define PHOTONS_MERGE_H

#include "partial_film.h"

/* Reads the files and makes their sum (free it with partial_film_free, whatever is returned). False
 * after a line to `messages`: one can't be read, is of another scene or other settings, or has
 * photons that are in another one; or there is no memory. */
bool merge_partial_films(const char *const *paths, int count, FILE *messages, partial_film *sum);

#endif
