/* SPDX-License-Identifier: MIT */
/* What a fuzz target and an engine share. A target (fuzz_<name>.c) decodes bytes into inputs,
 * compares answers and calls fuzz_find where they disagree; an engine (engine_libfuzzer.c,
 * engine_afl.c, replay.c) makes the bytes, and knows nothing of what they mean. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <surehit/tier.h>
#include <surehit/vector.h>

/* By the target.
 *
 * True when the bytes decoded to something that was compared. A find calls fuzz_find. */
bool fuzz_target(const uint8_t *data, size_t size);

/* A target's name, "sphere", ...: what stands behind fuzz_ in the file's name; and what changes the
 * `size` bytes in place, up to `max`, and returns the new size: NULL for the engine's own. */
extern const char fuzz_name[];
extern size_t (*const fuzz_mutator)(uint8_t *data, size_t size, size_t max, unsigned seed);
#define FUZZ_TARGET(name, mutator)                                                                 \
    const char fuzz_name[] = name;                                                                 \
    size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = mutator;

/* By fuzz_support.c.
 *
 * Prints what was found, one line, then the case line or the bytes as text where there is one, to
 * stderr and aborts. */
_Noreturn void fuzz_find(const char *law, const char *text);

/* A find where the law does not hold, of what was asked last (as by printf), and by which tier. */
void fuzz_ask(const char *format, ...) __attribute__((format(printf, 1, 2)));
void fuzz_by(sure_tier tier);
void expect(bool holds, const char *law);
void fuzz_promised(sure_tier tier, const char *broken); /* a law, or NULL */

/* Reading bytes: past the end everything is 0 and `short_of` is set. */
typedef struct {
    const uint8_t *at;
    size_t left;
    bool short_of;
} fuzz_bytes;

uint8_t fuzz_byte(fuzz_bytes *bytes);
uint64_t fuzz_u64(fuzz_bytes *bytes);  /* little-endian, on every machine */
double fuzz_double(fuzz_bytes *bytes); /* raw bits */
double fuzz_signed(fuzz_bytes *bytes); /* a byte: -128 to 127, and 0 to 1 */
double fuzz_share(fuzz_bytes *bytes);

/* By a leading byte: raw, a small integer, an integer times 2^k, near 1, or special (0, -0,
 * subnormal, largest, infinite, not a number). */
double fuzz_shaped_double(fuzz_bytes *bytes);

/* Each coordinate by one of these. */
sure_vec3 fuzz_vector(fuzz_bytes *bytes, double (*read)(fuzz_bytes *));

/* Moved by that many doubles, up to the infinity; not a number stays so. */
double fuzz_ulps(double x, int steps);

/* The next random number. (SplitMix64.) */
uint64_t fuzz_random(uint64_t *state);

/* A mutator for targets made of doubles, which may stand at any byte: flips exponents, moves by
 * ulps, copies one coordinate onto another, negates, sets to 0 or 1. */
size_t fuzz_mutate_doubles(uint8_t *data, size_t size, size_t max, unsigned seed);
