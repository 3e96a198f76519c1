/* SPDX-License-Identifier: MIT */
/* What the header promises of the quadratic, of any polynomial: its laws, and where a tier promises
 * something, counts and roots against the reference. */
#pragma once

#include <stdbool.h>

#include <surehit/tier.h>

typedef struct {
    double a, h, c; /* h is half of b */
} polynomial;

bool is_finite(polynomial p);

/* A power of two, 2^k, for law 3. Entry: finite. */
void quadratic_check(polynomial p, sure_tier tier, int k);

/* By who asks: fails where the law does not hold. */
void expect(bool holds, const char *law);
