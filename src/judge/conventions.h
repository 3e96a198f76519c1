/* SPDX-License-Identifier: MIT */
/* What a candidate says where conventions differ, told by asking it: cases of small whole numbers,
 * about an object of size 1, made to its entry conditions. */
#pragma once

#include "judging.h"

/* clang-format off */
#define EACH_CONVENTION(DO) \
    DO(TOUCH, "touch")          /* the ray but touches: of a disc, its rim */ \
    DO(INSIDE, "inside")        /* it starts inside */ \
    DO(OUTWARD, "surface, out") /* it starts on the boundary and leaves; of a flat one, along n */ \
    DO(INWARD, "surface, in")   /* ... and enters; against n */ \
    DO(END, "end")              /* the hit is at t_max */
/* clang-format on */

#define CONVENTION(NAME, name) CONVENTION_##NAME,
typedef enum { EACH_CONVENTION(CONVENTION) CONVENTIONS } convention;
#undef CONVENTION

/* "touch", ... */
const char *convention_name(convention which);

/* "miss", "0" (the start of the range), "exit", "hit" (at none of both), by the nearest of them, or
 * what else was said; "" where there is no such case or it is outside of the entry. */
typedef struct {
    char candidate[CONVENTIONS][32], contract[CONVENTIONS][32];
} convention_words;

/* False: the candidate or the truth can't be asked. */
bool conventions_ask(judging *self, sure_shape shape, convention_words *said);
