/* The random draws of one case: the n-th draw is a pure function of (seed, shape, regime, index,
 * n), so that no case needs the ones before it. Integers and exact steps only: the same on every
 * machine. C leaves the order of operands, arguments and initializers open: never two draws in one
 * of these. */
#ifndef CASES_RNG_H
#define CASES_RNG_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <surehit/vector.h>

typedef struct {
    uint64_t seed, shape, regime, index;
    uint64_t blocks; /* of four words, made so far */
    uint64_t word[4];
    int left; /* words of the last block not yet drawn */
} draws;

/* x times it is ldexp(x, exponent), and faster. -1022 <= exponent <= 1023. */
static inline double draw_power(int exponent)
{
    uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

draws draws_of(uint64_t seed, uint64_t shape, uint64_t regime, uint64_t index);

uint64_t draw_bits(draws *d);

/* True in `wins` of `of` draws. */
bool draw_chance(draws *d, int wins, int of);

/* One of low, ..., high; high - low < 2^31. */
int draw_integer(draws *d, int low, int high);

double draw_sign(draws *d); /* -1 or 1 */

/* low <= x <= high, evenly. */
double draw_between(draws *d, double low, double high);

/* 2^low <= x < 2^high, low < high, normal: the exponent is uniform and so is the mantissa. Against
 * the true log-uniform law no density is off by more than a factor of 1/ln 2 = 1.45. */
double draw_magnitude(draws *d, int low, int high);

/* A whole number of 1 to `bits` <= 53 binary digits, every number of digits equally likely. */
double draw_whole(draws *d, int bits);

/* The same with a sign. */
double draw_signed(draws *d, int bits);

/* The same, or, in a quarter of draws, 0. */
double draw_offset(draws *d, int bits);

/* Three offsets ... */
sure_vec3 draw_offsets(draws *d, int bits);

/* ... that are not all 0. */
sure_vec3 draw_whole_vector(draws *d, int bits);

/* A direction, evenly over the sphere and of length 1, both up to rounding. */
sure_vec3 draw_unit(draws *d);

#endif
