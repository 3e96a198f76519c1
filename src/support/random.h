/* Random numbers of one photon or case: the n-th is a pure function of (key, number, n), so that
 * none needs the ones before it. Integers and square roots only: the same on every machine. C
 * leaves the order of operands open: never two draws in one expression. */
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <surehit/vector.h>

/* Random123 refuses machines that it was not tried on. Threefry adds, rotates and xors words of 64
 * bits, and nothing else: it passes as one of those. */
#ifdef __wasm__
#define __riscv
#include <Random123/threefry.h>
#undef __riscv
#else
#include <Random123/threefry.h>
#endif

/* Streams of one seed that have nothing in common. */
typedef enum { RANDOM_PHOTON, RANDOM_CAUSTIC } random_purpose;

typedef struct {
    uint64_t key[3], number;
    uint64_t blocks; /* of four words, made so far */
    uint64_t word[4];
    int left; /* words of the last block not yet drawn */
} random_stream;

static inline random_stream random_stream_of(uint64_t seed, random_purpose purpose, uint64_t number)
{
    return (random_stream){.key = {seed, (uint64_t)purpose}, .number = number};
}

/* Makes the next block where none of the last one is left. */
static inline void random_refill(random_stream *s)
{
    if (s->left > 0)
        return;
    threefry4x64_ctr_t counter = {{s->number, s->blocks++, 0, 0}};
    threefry4x64_key_t key = {{s->key[0], s->key[1], s->key[2], 0}};
    threefry4x64_ctr_t block = threefry4x64(counter, key);
    memcpy(s->word, block.v, sizeof s->word);
    s->left = 4;
}

static inline uint64_t random_bits(random_stream *s)
{
    random_refill(s);
    return s->word[4 - s->left--];
}

/* In [0, 1), a whole number of 2^-53. */
static inline double random_fraction(random_stream *s)
{
    return (double)(random_bits(s) >> 11) * 0x1p-53;
}

/* Evenly over the unit sphere, up to rounding: a point of the disc, stretched over the sphere with
 * equal areas. (G. Marsaglia, Choosing a point from the surface of a sphere, 1972.) */
static inline sure_vec3 random_direction(random_stream *s)
{
    for (;;) {
        double x = 2 * random_fraction(s) - 1;
        double y = 2 * random_fraction(s) - 1;
        double square = x * x + y * y;
        if (square < 1) {
            double stretch = 2 * sqrt(1 - square);
            return (sure_vec3){x * stretch, y * stretch, 1 - 2 * square};
        }
    }
}
