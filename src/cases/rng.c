/* SPDX-License-Identifier: MIT */
#include "rng.h"

#include "../numbers/places.h"
#include "../geometry/coordinate.h"

#include <math.h>

rng rng_of(uint64_t seed, uint64_t shape, uint64_t regime, uint64_t index)
{
    return (rng){.key = {seed, shape, regime}, .number = index};
}

/* A block's words last to first. */
uint64_t rng_bits(rng *g)
{
    random_refill(g);
    return g->word[--g->left];
}

/* Of n: by the upper half of n times a 32-bit fraction, which favours none by more than n 2^-32. */
static uint32_t below(rng *g, uint32_t n)
{
    return (uint32_t)(((rng_bits(g) >> 32) * n) >> 32);
}

bool rng_chance(rng *g, int wins, int of)
{
    return below(g, (uint32_t)of) < (uint32_t)wins;
}

int rng_integer(rng *g, int low, int high)
{
    return low + (int)below(g, (uint32_t)(high - low) + 1);
}

double rng_sign(rng *g)
{
    return rng_bits(g) >> 63 ? -1 : 1;
}

static double fraction(rng *g)
{
    return (double)(rng_bits(g) >> 11) * 0x1p-53;
}

double rng_between(rng *g, double low, double high)
{
    return low + (high - low) * fraction(g);
}

double rng_magnitude(rng *g, int low, int high)
{
    double mantissa = 1 + (double)(rng_bits(g) >> 12) * 0x1p-52;
    int exponent = rng_integer(g, low, high - 1);
    return times_two_to(mantissa, exponent);
}

double rng_whole(rng *g, int bits)
{
    int digits = rng_integer(g, 1, bits);
    uint64_t leading = (uint64_t)1 << (digits - 1);
    return (double)(leading | (rng_bits(g) & (leading - 1)));
}

double rng_signed(rng *g, int bits)
{
    double sign = rng_sign(g);
    return sign * rng_whole(g, bits);
}

double rng_offset(rng *g, int bits)
{
    return rng_chance(g, 1, 4) ? 0 : rng_signed(g, bits);
}

sure_vec3 rng_offsets(rng *g, int bits)
{
    sure_vec3 v;
    for (int i = 0; i < 3; i++)
        *coordinate_of(&v, i) = rng_offset(g, bits);
    return v;
}

sure_vec3 rng_whole_vector(rng *g, int bits)
{
    sure_vec3 v;
    do
        v = rng_offsets(g, bits);
    while (v.x == 0 && v.y == 0 && v.z == 0);
    return v;
}

sure_vec3 rng_unit(rng *g)
{
    for (;;) {
        sure_vec3 v;
        for (int i = 0; i < 3; i++)
            *coordinate_of(&v, i) = rng_between(g, -1, 1);
        double square = v.x * v.x + v.y * v.y + v.z * v.z;
        if (square > 0x1p-10 && square <= 1) {
            double length = sqrt(square);
            return (sure_vec3){v.x / length, v.y / length, v.z / length};
        }
    }
}
