/* What became of photons, in words: of a forward rendering and of shares merged. */
#ifndef CLI_PHOTONS_H
#define CLI_PHOTONS_H

#include "../photons/partial_film.h"

/* Seconds that all of the photons take, where they are not known. */
#define PHOTONS_UNTIMED (-1.0)

/* Counts, and a pixel's variance, which is given in seconds, too. */
void photons_print(FILE *out, const share *of, double seconds);

/* The same as members of a JSON object: ", "photons": ..." */
void photons_print_json(FILE *out, const share *of, double seconds);

/* "0 to 999, 2000 to 2999" */
void photons_print_ranges(FILE *out, const share *of);

#endif
