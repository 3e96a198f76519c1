/* SPDX-License-Identifier: MIT */
/* Random numbers of one photon or case: the n-th is a pure function of (key, number, n), so that
 * none needs the ones before it. Integers and square roots only: the same on every machine. C
 * leaves the order of operands open: never two draws in one expression. */
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <surehit/vector.h>

/* Streams of one seed that have nothing in common. */
typedef enum { RANDOM_PHOTON, RANDOM_CAUSTIC } random_purpose;

typedef struct {
    uint64_t key[3], number;
    uint64_t blocks; /* of four words, made so far */
    uint64_t word[4];
    int left; /* words of the last block not yet drawn */
} random_stream;

/* Threefry-4x64 of 20 rounds: J. Salmon, M. Moraes, R. Dror, D. Shaw, Parallel random numbers: as
 * easy as 1, 2, 3. SC 2011. The library needs no more of Random123 than this. */
#define RANDOM_PARITY UINT64_C(0x1bd11bdaa9fc1a22)

static inline void random_mix(uint64_t *a, uint64_t *b, int turn)
{
    *a += *b;
    *b = (*b << turn | *b >> (64 - turn)) ^ *a;
}

/* Four rounds, of words in registers: turned by numbers that the compiler knows. */
static inline void random_first_rounds(uint64_t x[4])
{
    random_mix(&x[0], &x[1], 14);
    random_mix(&x[2], &x[3], 16);
    random_mix(&x[0], &x[3], 52);
    random_mix(&x[2], &x[1], 57);
    random_mix(&x[0], &x[1], 23);
    random_mix(&x[2], &x[3], 40);
    random_mix(&x[0], &x[3], 5);
    random_mix(&x[2], &x[1], 37);
}

static inline void random_other_rounds(uint64_t x[4])
{
    random_mix(&x[0], &x[1], 25);
    random_mix(&x[2], &x[3], 33);
    random_mix(&x[0], &x[3], 46);
    random_mix(&x[2], &x[1], 12);
    random_mix(&x[0], &x[1], 58);
    random_mix(&x[2], &x[3], 22);
    random_mix(&x[0], &x[3], 32);
    random_mix(&x[2], &x[1], 32);
}

static inline void random_add_key(uint64_t x[4], const uint64_t key[5], unsigned times)
{
    x[0] += key[times % 5];
    x[1] += key[(times + 1) % 5];
    x[2] += key[(times + 2) % 5];
    x[3] += key[(times + 3) % 5] + times;
}

/* x: the counter, which becomes the block. The last key is RANDOM_PARITY and all others. */
static inline void random_threefry(uint64_t x[4], const uint64_t key[5])
{
    random_add_key(x, key, 0);
    random_first_rounds(x);
    random_add_key(x, key, 1);
    random_other_rounds(x);
    random_add_key(x, key, 2);
    random_first_rounds(x);
    random_add_key(x, key, 3);
    random_other_rounds(x);
    random_add_key(x, key, 4);
    random_first_rounds(x);
    random_add_key(x, key, 5);
}

static inline random_stream random_stream_of(uint64_t seed, random_purpose purpose, uint64_t number)
{
    return (random_stream){.key = {seed, (uint64_t)purpose}, .number = number};
}

/* Makes the next block where none of the last one is left. */
static inline void random_refill(random_stream *s)
{
    if (s->left > 0)
        return;
    const uint64_t *k = s->key, key[5] = {k[0], k[1], k[2], 0, RANDOM_PARITY ^ k[0] ^ k[1] ^ k[2]};
    memcpy(s->word, (uint64_t[4]){s->number, s->blocks++}, sizeof s->word);
    random_threefry(s->word, key);
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
