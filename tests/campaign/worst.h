/* SPDX-License-Identifier: MIT */
/* The closest calls of a campaign: of each shape and question the cases that need most bits. Those
 * of a union are among those of its parts, and equals go by regime and number: so they add up. */
#pragma once

#include "regimes.h"

#include <jansson.h>

/* How many bits of the numbers a question is decided by have to be known:
 *
 * DECISION  does the line meet it? By how many binades what decides that is below its largest
 *           term: a body's discriminant; of a disc how far within its rim its plane is crossed; of
 *           a box by how much the line enters before it leaves; of a plane how far above it the
 *           ray starts, or how steeply it goes.
 * CAP       is a cap's plane crossed within the rim? As of a disc.
 * ROUNDING  which double is next to t? 53, and by how many binades t is nearer than an ulp to the
 *           midpoint of two doubles. */
typedef enum { WORST_DECISION, WORST_CAP, WORST_ROUNDING, WORST_QUESTIONS } worst_question;
extern const char *const worst_names[WORST_QUESTIONS];

/* 0: it is not asked, or is told by an exact zero or midpoint; t is below the least normal double.
 * In exact numbers. Entry: the case is valid. */
int worst_bits(const sure_case *question, worst_question of);

/* No valid case of doubles needs more: exact.h has the sizes of polynomials of inputs, of which a
 * discriminant's, a rim's or, at a midpoint, a body's degree is known; 0: nothing is asked. */
int worst_bound(sure_shape shape, worst_question of);

#define WORST_KEPT 10

typedef struct {
    int bits;
    regime which;
    uint64_t index;
} worst_call;

typedef struct {
    int count;
    worst_call list[WORST_KEPT];
} worst_calls;

void worst_add(worst_calls *to, worst_call more);

/* Of each question, where it needs more than others. */
void worst_look(const sure_case *question, regime which, uint64_t index,
                worst_calls to[WORST_QUESTIONS]);

/* [[bits,regime,index],...]; reading returns what is wrong, or NULL. */
json_t *worst_calls_json(const worst_calls *of);
const char *worst_calls_take(const json_t *list, worst_calls *read);
