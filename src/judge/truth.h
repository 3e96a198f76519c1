/* SPDX-License-Identifier: MIT */
/* The right answers, of the library's `exact` or of a program that knows them. */
#pragma once

#include "candidates/candidate.h"
#include "verdict/tally.h"

/* What a program is asked: walls for their first hits. All cases of a block are such, or none. */
typedef enum { TRUTH_HITS, TRUTH_INTERVALS, TRUTH_WALLS, TRUTH_KINDS } truth_kind;

typedef struct {
    candidate *programs[TRUTH_KINDS]; /* the same one; NULL: `exact` */
    block room;                       /* for its replies */
} truth;

/* That of surehit-reference, which is looked for beside this program, where both were built, and on
 * the PATH. Its answers are whole lines: part, normal and field of each. False after a message. */
bool truth_reference(double time_limit, truth *known, char *message);
void truth_close(truth *known);

/* Can it be started? */
bool truth_has_reference(void);

/* The answers to `count` cases of one shape. Where there are replies, `exact` is asked for normals
 * only to hold theirs against them; others are 0. False after a message: the program gave none. */
bool truth_ask(truth *known, query asks, const sure_case *cases, const reply *replies, int count,
               case_answer *answers, char *message);

/* An example's answer with its normal. */
void truth_complete(const truth *known, example *one);

/* Whether they are hits, misses or invalid: quicker by far where the answer is hard to round. */
bool truth_statuses(truth *known, const sure_case *cases, int count, sure_status *statuses,
                    char *message);
