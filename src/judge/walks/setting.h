/* SPDX-License-Identifier: MIT */
/* Where walks take place (docs/walks.md): one solid, or two that touch. */
#pragma once

#include "../../cases/regimes.h"

/* clang-format off */
#define EACH_WALK_KIND(DO) \
    DO(ALONE, "alone")     /* one solid, turned and moved anyhow */ \
    DO(THIN, "thin")       /* flat, or a needle: 2^-24 to 2^-4 as thick as long */ \
    DO(NESTED, "nested")   /* a smaller one touches the solid from inside, exactly, */ \
    DO(SHELL, "shell")     /* ... and nearly fills it, */ \
    DO(BESIDE, "beside")   /* or one of its size touches it from outside */ \
    DO(FAR, "far")         /* alone, nested or beside, 2^10 to 2^40 sizes from the origin */ \
    DO(GRAZING, "grazing") /* the same at home; surfaces are left with a slope of 2^-40 to 2^-2 */
/* clang-format on */

#define WALK_KIND(NAME, name) WALK_##NAME,
typedef enum { EACH_WALK_KIND(WALK_KIND) WALK_KINDS } walk_kind;
#undef WALK_KIND

/* "alone", ..., NULL at the end. */
extern const char *const walk_kind_names[];

/* Does it mean anything for the shape? */
bool walk_kind_applies(sure_shape shape, walk_kind kind);

#define WALK_SOLIDS 2
typedef struct {
    sure_object solids[WALK_SOLIDS];
    int count;
    sure_vec3 start; /* within the first, but for roundings */
} setting;

/* Entry: the kind applies. */
setting setting_of(sure_shape shape, walk_kind kind, rng *g);
