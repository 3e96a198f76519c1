/* SPDX-License-Identifier: MIT */
/* A candidate held against the truth: over the cases of a regime, or over given ones. */
#pragma once

#include "../cases/regimes.h"
#include "referee/referee.h"
#include "verdict/promise.h"
#include "truth.h"

#include <stdio.h>

typedef enum {
    SUBJECT_NONE,
    SUBJECT_TIER,
    SUBJECT_LIBRARY,
    SUBJECT_COMMAND,
    SUBJECT_ANSWERS, /* of a file; "-": standard input */
    SUBJECT_CALLBACK /* at hand: judging_of */
} subject_kind;

/* Who is judged, and how. */
typedef struct {
    subject_kind subject;
    const char *name; /* of the candidate */
    sure_tier tier;   /* where it is one */
    candidate_options how;
    int by_reference;  /* the truth: surehit-reference; else the tier exact */
    bool untimed;      /* no times are taken */
    bool instructions; /* are told, too (instructions.h) */
    uint64_t seed;
    /* Of a whole run (judging_run). */
    bool queries[QUERIES], some_queries; /* no others; else all of a library, and hits of a tier */
    const char *cases; /* their file, "-": standard input; NULL: they are made, of */
    regime_rows rows;  /* shapes that are asked for must be answered */
    uint64_t count;
    promises required;
    margins told;
    identity surehit;                 /* that judges; the tiers' */
    const char *json, *junit, *sarif; /* paths, or NULL */
} judging_plan;

#define JUDGING_GIVEN REGIMES      /* in a regime's place: the cases were given, and name none */
#define JUDGING_ROWS (REGIMES + 1) /* of a shape */
#define JUDGING_ALL_ROWS (QUERIES * SURE_SHAPES * JUDGING_ROWS)

/* Nanoseconds a ray, all three asked the same cases one after the other, with normals where the
 * candidate gives them (a tier: hits alone); apart from that of building an object, where the
 * candidate prepares them; 0 where not known. */
typedef struct {
    double candidate, textbook, certain, building;
} judging_times;

typedef struct {
    query asks;
    sure_shape shape;
    int which; /* a regime, or JUDGING_GIVEN */
    verdict sum;
    refereed looked_at;
    judging_times times, instructions; /* these of the first cases */
} judging_row;

/* "typical", ..., "given" */
const char *judging_row_name(int which);

/* "sphere", "sphere interval", ... */
typedef char judging_words[32];
const char *judging_topic(query asks, sure_shape shape, judging_words words);

typedef struct judging judging;

/* NULL after a message: the candidate, its answers or the truth can't be had. The plan has to stay.
 */
judging *judging_open(const judging_plan *plan, char *message);

/* Of a candidate that is at hand, and is closed with it (where NULL is returned, at once): held
 * against the tier exact, and no times are taken. */
judging *judging_of(const judging_plan *plan, candidate *asked, char *message);
void judging_close(judging *self);

/* Who it is: a tier is surehit, a program its command. */
identity judging_who(const judging *self);

/* Which shapes it answers, and in what; who has written answers before can't be asked. */
const candidate *judging_asked(const judging *self);

/* Is that asked for and answered? */
bool judging_asks(const judging *self, query asks, sure_shape shape);

/* Judges the first `count` cases of a regime that applies to the shape. False after a message. */
bool judging_regime(judging *self, query asks, sure_shape shape, regime which, uint64_t count,
                    judging_row *row, char *message);

/* Judges the case lines of the plan's file, a row for each query, shape and regime that occurs, is
 * asked for and is answered, JUDGING_ALL_ROWS at most. `left_out` counts the other lines. False,
 * too, where there is no case. */
bool judging_given(judging *self, judging_row *rows, int *count, uint64_t *left_out, char *message);

/* True unless there are more answers than cases. */
bool judging_answers_end(const judging *self, char *message);

/* What the candidate says to up to JUDGING_SEVERAL cases of one shape, and the truth; not found: it
 * is no case for a candidate in float. False: the truth is not told, or the candidate can't be
 * asked. */
#define JUDGING_SEVERAL 2048
bool judging_several(judging *self, query asks, const sure_case *questions, int count,
                     example *answered);

/* Are candidate and truth at hand for a single case? Else a program is started each time, and had
 * better be asked several at once. */
bool judging_is_quick(const judging *self);

/* The cases to look at: of every kind of fault, and of the largest errors, one, made simple. Their
 * kinds are the faults, then these. */
#define WORST_T FAULTS
#define WORST_NORMAL (FAULTS + 1)
#define WORST_KINDS (FAULTS + 2)
typedef struct {
    int kind;
    query asks;
    sure_shape shape;
    int which; /* the regime where it was met, or JUDGING_GIVEN */
    precision in;
    double margin; /* in the plan's unit, of a wrong decision; 0: not known */
    example found; /* made simple where the candidate still does it then */
} worst_case;

/* Up to one of each kind, in their order; how many. */
int worst_find(judging *self, const judging_row *rows, int count, worst_case list[WORST_KINDS]);

/* In ulps: of t for WORST_T, of the normal for WORST_NORMAL. */
double worst_size(int kind, const example *one, precision in);

margin_unit judging_unit(const judging *self);

/* Its faults, but for those that its entry conditions allow. */
unsigned judging_faults(const judging *self, const example *one);

/* A whole judgement: every row is judged and printed as it comes, then the worst cases and the
 * promises. Returns 0, or 1 where a promise is broken; after a line to standard error 1 where the
 * JSON file can't be written, 2 where there is no candidate, case, answer or truth. */
int judging_run(const judging_plan *plan);
