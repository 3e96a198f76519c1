/* SPDX-License-Identifier: MIT */
/* Refraction by its angles, in 500 bits: t from Snell's law, the direction by turning from the
 * normal by t, and the share that is reflected as what is not transmitted. */
#pragma once

#include <stdbool.h>

#include <surehit/refract.h>
#include <surehit/tier.h>

typedef struct {
    sure_vec3 d, n;
    double ratio;
} refraction_question;

typedef struct {
    unsigned long refracted, total, mistaken; /* of the last: as far as the bound allows it */
} refraction_counts;

/* Laws 5, 6 and 10 of refract.h, and its bounds: what the tier breaks, or NULL. Entry: a question
 * in the tier's numbers. Asked are those for which the bounds are published. */
const char *refraction_broken(sure_tier tier, const refraction_question *q,
                              refraction_counts *count);

/* Do the vectors keep products of four of their numbers in the tier's range? */
bool refraction_is_moderate(sure_tier tier, const refraction_question *q);
