/* SPDX-License-Identifier: MIT */
/* The random draws of one case: the n-th draw is a pure function of (seed, shape, regime, index,
 * n), so that no case needs the ones before it. Integers and exact steps only: the same on every
 * machine. C leaves the order of operands, arguments and initializers open: never two draws in one
 * of these. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "../support/random.h"

typedef random_stream rng;

rng rng_of(uint64_t seed, uint64_t shape, uint64_t regime, uint64_t index);

uint64_t rng_bits(rng *g);

/* True in `wins` of `of` draws. */
bool rng_chance(rng *g, int wins, int of);

/* One of low, ..., high; high - low < 2^31. */
int rng_integer(rng *g, int low, int high);

double rng_sign(rng *g); /* -1 or 1 */

/* low <= x <= high, evenly. */
double rng_between(rng *g, double low, double high);

/* 2^low <= x < 2^high, low < high, normal: the exponent is uniform and so is the mantissa. Against
 * the true log-uniform law no density is off by more than a factor of 1/ln 2 = 1.45. */
double rng_magnitude(rng *g, int low, int high);

/* A whole number of 1 to `bits` <= 53 binary digits, every number of digits equally likely. */
double rng_whole(rng *g, int bits);

/* The same with a sign. */
double rng_signed(rng *g, int bits);

/* The same, or, in a quarter of draws, 0. */
double rng_offset(rng *g, int bits);

/* Three offsets ... */
sure_vec3 rng_offsets(rng *g, int bits);

/* ... that are not all 0. */
sure_vec3 rng_whole_vector(rng *g, int bits);

/* A direction, evenly over the sphere and of length 1, both up to rounding. */
sure_vec3 rng_unit(rng *g);
