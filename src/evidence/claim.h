/* SPDX-License-Identifier: MIT */
/* A pixel of a certificate held against the tier exact. */
#pragma once

#include "certificate.h"

/* How a pixel's line is wrong. */
typedef enum {
    CLAIM_RIGHT,
    CLAIM_RAY,    /* another one belongs to the pixel */
    CLAIM_OBJECT, /* another object is seen, or none */
    CLAIM_PART,
    CLAIM_T,     /* it is farther off than its error says */
    CLAIM_VAGUE, /* the error is larger than docs/contract.md allows */
    CLAIM_VERDICTS
} claim_verdict;

/* Is what it says of the part's i-th pixel true? The true answer is in *seen and, of a hit, in
 * *nearest. */
claim_verdict claim_check(const sure_scene *scene, const certificate *of, size_t i,
                          sure_status *seen, sure_nearest *nearest);
