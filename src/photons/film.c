/* SPDX-License-Identifier: MIT */
#include "film.h"

#include <math.h>
#include <stdlib.h>

#define STEPS 0x1p32 /* of one */
#define CHANNELS 3

bool film_new(int width, int height, film *out)
{
    if (width < 1 || height < 1 ||
        (size_t)height > PTRDIFF_MAX / sizeof *out->pixels / (size_t)width)
        return false;
    film_pixel *pixels = calloc((size_t)height, (size_t)width * sizeof *pixels);
    if (pixels)
        *out = (film){width, height, pixels};
    return pixels != NULL;
}

void film_free(film *of)
{
    free(of->pixels);
    of->pixels = NULL;
}

/* Of all pixels. */
static size_t channel_count(const film *of)
{
    return CHANNELS * (size_t)of->width * (size_t)of->height;
}

static const film_sum most = -(film_sum)1;

/* The nearest step. Nothing here is rounded but by intention: a number of at least 2^53 is whole,
 * and the places of a smaller one behind the point are its own. */
static film_sum quantised(double value)
{
    double steps = value * STEPS;
    if (!(steps > 0))
        return 0;
    if (steps >= 0x1p53)
        return steps < 0x1p128 ? (film_sum)steps : most;
    uint64_t whole = (uint64_t)steps;
    return whole + (steps - (double)whole >= 0.5);
}

/* Stays at the most: for what is not negative the order still does not matter. */
static void add(film_sum *to, film_sum more)
{
    *to = more > most - *to ? most : *to + more;
}

void film_add(film *to, int column, int row, sure_vec3 value)
{
    const double values[CHANNELS] = {value.x, value.y, value.z};
    size_t from_top = (size_t)(to->height - 1 - row);
    film_pixel *pixel = &to->pixels[from_top * (size_t)to->width + (size_t)column];
    for (int i = 0; i < CHANNELS; i++) {
        if (!(values[i] > 0))
            continue;
        add(&pixel->value[i], quantised(values[i]));
        add(&pixel->square[i], quantised(values[i] * values[i]));
    }
}

void film_merge(film *to, const film *from)
{
    for (size_t i = 0; i < channel_count(to); i++) {
        film_pixel *pixel = &to->pixels[i / CHANNELS], *more = &from->pixels[i / CHANNELS];
        add(&pixel->value[i % CHANNELS], more->value[i % CHANNELS]);
        add(&pixel->square[i % CHANNELS], more->square[i % CHANNELS]);
    }
}

static double number(film_sum sum)
{
    return ((double)(uint64_t)(sum >> 64) * 0x1p64 + (double)(uint64_t)sum) / STEPS;
}

static double value_of(const film *of, size_t channel)
{
    return number(of->pixels[channel / CHANNELS].value[channel % CHANNELS]);
}

bool film_picture_new(const film *from, uint64_t photons, picture *image)
{
    if (!picture_new(from->width, from->height, image))
        return false;
    for (size_t i = 0; i < channel_count(from); i++)
        image->rgb[i] = picture_level(value_of(from, i) / (double)photons);
    return true;
}

double film_mean(const film *of, uint64_t photons)
{
    double sum = 0;
    for (size_t i = 0; i < channel_count(of); i++)
        sum += value_of(of, i);
    return sum / ((double)photons * (double)channel_count(of));
}

double film_variance(const film *of, uint64_t photons)
{
    double sum = 0, n = (double)photons;
    if (photons < 2)
        return INFINITY;
    for (size_t i = 0; i < channel_count(of); i++) {
        double mean = value_of(of, i) / n;
        double square = number(of->pixels[i / CHANNELS].square[i % CHANNELS]) / n;
        /* Rounding may take more than there is where every photon gives the same. */
        sum += fmax(square - mean * mean, 0);
    }
    return sum / ((n - 1) * (double)channel_count(of));
}
