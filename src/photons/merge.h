/* Shares of one scene's photons added up. */
#ifndef PHOTONS_MERGE_H
#define PHOTONS_MERGE_H

#include "partial_film.h"

typedef enum { MERGE_DONE, MERGE_UNFIT, MERGE_NO_MEMORY } merge_status;

/* Reads the files and makes their sum (free it with partial_film_free, whatever is returned).
 * MERGE_UNFIT: one can't be read, is of another scene or other settings, or has photons that are in
 * another one. Unless all is done, one line was written to `messages`. */
merge_status merge_partial_films(const char *const *paths, int count, FILE *messages,
                                 partial_film *sum);

#endif
