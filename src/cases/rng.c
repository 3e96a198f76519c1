#include "rng.h"

#include <math.h>

#include <Random123/threefry.h>

draws draws_of(uint64_t seed, uint64_t shape, uint64_t regime, uint64_t index)
{
    return (draws){.seed = seed, .shape = shape, .regime = regime, .index = index};
}

uint64_t draw_bits(draws *d)
{
    if (d->left == 0) {
        threefry4x64_ctr_t counter = {{d->index, d->blocks++, 0, 0}};
        threefry4x64_key_t key = {{d->seed, d->shape, d->regime, 0}};
        threefry4x64_ctr_t block = threefry4x64(counter, key);
        for (int i = 0; i < 4; i++)
            d->word[i] = block.v[i];
        d->left = 4;
    }
    return d->word[--d->left];
}

/* Of n: by the upper half of n times a 32-bit fraction, which favours none by more than n 2^-32. */
static uint32_t below(draws *d, uint32_t n)
{
    return (uint32_t)(((draw_bits(d) >> 32) * n) >> 32);
}

bool draw_chance(draws *d, int wins, int of)
{
    return below(d, (uint32_t)of) < (uint32_t)wins;
}

int draw_integer(draws *d, int low, int high)
{
    return low + (int)below(d, (uint32_t)(high - low) + 1);
}

double draw_sign(draws *d)
{
    return draw_bits(d) >> 63 ? -1 : 1;
}

static double fraction(draws *d)
{
    return (double)(draw_bits(d) >> 11) * 0x1p-53;
}

double draw_between(draws *d, double low, double high)
{
    return low + (high - low) * fraction(d);
}

double draw_magnitude(draws *d, int low, int high)
{
    double mantissa = 1 + (double)(draw_bits(d) >> 12) * 0x1p-52;
    int exponent = draw_integer(d, low, high - 1);
    bool normal = exponent >= -1022 && exponent <= 1023;
    return normal ? mantissa * draw_power(exponent) : ldexp(mantissa, exponent);
}

double draw_whole(draws *d, int bits)
{
    int digits = draw_integer(d, 1, bits);
    uint64_t leading = (uint64_t)1 << (digits - 1);
    return (double)(leading | (draw_bits(d) & (leading - 1)));
}

double draw_signed(draws *d, int bits)
{
    double sign = draw_sign(d);
    return sign * draw_whole(d, bits);
}

double draw_offset(draws *d, int bits)
{
    return draw_chance(d, 1, 4) ? 0 : draw_signed(d, bits);
}

sure_vec3 draw_offsets(draws *d, int bits)
{
    sure_vec3 v;
    v.x = draw_offset(d, bits);
    v.y = draw_offset(d, bits);
    v.z = draw_offset(d, bits);
    return v;
}

sure_vec3 draw_whole_vector(draws *d, int bits)
{
    sure_vec3 v;
    do
        v = draw_offsets(d, bits);
    while (v.x == 0 && v.y == 0 && v.z == 0);
    return v;
}

sure_vec3 draw_unit(draws *d)
{
    for (;;) {
        sure_vec3 v;
        v.x = draw_between(d, -1, 1);
        v.y = draw_between(d, -1, 1);
        v.z = draw_between(d, -1, 1);
        double square = v.x * v.x + v.y * v.y + v.z * v.z;
        if (square > 0x1p-10 && square <= 1) {
            double length = sqrt(square);
            return (sure_vec3){v.x / length, v.y / length, v.z / length};
        }
    }
}
