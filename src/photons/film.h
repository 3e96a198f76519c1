/* SPDX-License-Identifier: MIT */
/* A picture as a sum over photons, exact: the same whatever the order of what is added. */
#pragma once

#include "../image/picture.h"

#include <surehit/vector.h>

/* Steps of 2^-32 up to 2^96, where it stays. */
__extension__ typedef unsigned __int128 film_sum;

typedef struct {
    film_sum value[3];  /* red, green, blue */
    film_sum square[3]; /* of the values added */
} film_pixel;

typedef struct {
    int width, height;
    film_pixel *pixels; /* rows from the top */
} film;

/* A dark one; false when there is no memory. */
bool film_new(int width, int height, film *out);
void film_free(film *of);

/* Row 0 is the lowest. Value and square are each rounded to the nearest step, a half up; what is
 * negative or no number counts as nothing. Not for two threads at once. */
void film_add(film *to, int column, int row, sure_vec3 value);

/* Of the same size. */
void film_merge(film *to, const film *from);

/* Makes the picture (free it with picture_free) of the means over so many photons, clamped to 0..1,
 * times 255, rounded to nearest. False when there is no memory. */
bool film_picture_new(const film *from, uint64_t photons, picture *image);

/* The mean value of pixels and channels. */
double film_mean(const film *of, uint64_t photons);

/* The variance of a pixel's mean value, averaged over pixels and channels: by values' squares less
 * the square of their sum. For photons that light one point each it is without bias. Infinite for
 * less than two photons, of which nothing is known. */
double film_variance(const film *of, uint64_t photons);
