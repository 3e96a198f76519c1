/* What became of photons: of a forward rendering, and of shares merged. */
#ifndef PHOTONS_PHOTON_COUNTS_H
#define PHOTONS_PHOTON_COUNTS_H

#include "partial_film.h"

#include <jansson.h>

/* Seconds that all of the photons take, where they are not known. */
#define PHOTONS_UNTIMED (-1.0)

/* Counts, and a pixel's variance, which is given in seconds, too. */
void photons_print(FILE *out, const partial_film *of, double seconds);

/* The same for programs; NULL when there is no memory. */
json_t *photons_json(const partial_film *of, double seconds);

/* The counts alone, and read back strictly. */
json_t *photon_counts_json(const sure_forward_statistics *sum);
bool photon_counts_from_json(const json_t *object, sure_forward_statistics *sum);

/* "0 to 999, 2000 to 2999" */
void photons_print_ranges(FILE *out, const partial_film *of);

#endif
