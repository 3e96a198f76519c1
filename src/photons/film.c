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

static size_t pixel_count(const film *of)
{
    return (size_t)of->width * (size_t)of->height;
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
    for (size_t i = 0; i < pixel_count(to); i++) {
        for (int j = 0; j < CHANNELS; j++) {
            add(&to->pixels[i].value[j], from->pixels[i].value[j]);
            add(&to->pixels[i].square[j], from->pixels[i].square[j]);
        }
    }
}

static double number(film_sum sum)
{
    return ((double)(uint64_t)(sum >> 64) * 0x1p64 + (double)(uint64_t)sum) / STEPS;
}

bool film_picture_new(const film *from, uint64_t photons, picture *image)
{
    if (!picture_new(from->width, from->height, image))
        return false;
    for (size_t i = 0; i < pixel_count(from); i++) {
        for (int j = 0; j < CHANNELS; j++)
            image->rgb[CHANNELS * i + (size_t)j] =
                picture_level(number(from->pixels[i].value[j]) / (double)photons);
    }
    return true;
}

double film_mean(const film *of, uint64_t photons)
{
    double sum = 0;
    for (size_t i = 0; i < pixel_count(of); i++) {
        for (int j = 0; j < CHANNELS; j++)
            sum += number(of->pixels[i].value[j]);
    }
    return sum / ((double)photons * (double)pixel_count(of) * CHANNELS);
}

double film_variance(const film *of, uint64_t photons)
{
    double sum = 0, n = (double)photons;
    if (photons < 2)
        return INFINITY;
    for (size_t i = 0; i < pixel_count(of); i++) {
        for (int j = 0; j < CHANNELS; j++) {
            double mean = number(of->pixels[i].value[j]) / n;
            /* Rounding may take more than there is where every photon gives the same. */
            sum += fmax(number(of->pixels[i].square[j]) / n - mean * mean, 0);
        }
    }
    return sum / ((n - 1) * (double)pixel_count(of) * CHANNELS);
}
