/* SPDX-License-Identifier: MIT */
/* Frozen sets of cases: whoever names one says which cases were asked, down to the last bit. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    const char *name;             /* "2026.1": the year, and the first of it */
    uint64_t seed, count;         /* of each shape and regime, ... */
    const char *shapes, *regimes; /* ... of these, a blank between */
    const char *sha256;           /* of its lines as `surehit cases --set` writes them */
} case_set;

/* They end with one without a name; none that was published ever changes. */
extern const case_set case_sets[];

bool case_set_has(const case_set *set, const char *shape, const char *regime);
