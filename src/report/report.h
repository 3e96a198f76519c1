/* SPDX-License-Identifier: MIT */
/* Several candidates asked the same cases, as one JSON document and one page that draws it
 * (docs/report.md). */
#pragma once

#include "../judge/findings/findings.h"
#include "../photons/render_file.h"
#include "../support/progress.h"

#include <jansson.h>

#define REPORT_CANDIDATES 32

/* Cases that were to be asked. */
uint64_t report_row_cases(const judging_row *row);

/* The most that judge at a time. */
#define REPORT_PROCESSES 256

/* What its answers are held against. */
typedef enum {
    REPORT_BY_EXACT,
    REPORT_BY_REFERENCE, /* certain and exact: CGAL, which shares nothing with them */
    REPORT_BY_LIKE       /* they, where the reference is not to be had: exact, and no evidence */
} report_truth;

typedef struct {
    bool in_float;                   /* it is asked and answers in float */
    bool with_normals;               /* it gives them with every hit: its time includes them */
    char trouble[CANDIDATE_MESSAGE]; /* why it could not be asked; empty: it was */
    identity who;
    judging_row rows[REGIMES]; /* of the times the candidate's, a ray's hit; 0: not known */
    worst_case worst[WORST_KINDS];
    int worst_count;
} report_shape;

typedef struct {
    const char *name;    /* "certain", "embree" */
    const char *library; /* its file; NULL: a tier of the library */
    sure_tier tier;
    report_truth truth;
    report_shape *shapes; /* SURE_SHAPES, once it was asked */
} report_candidate;

typedef struct {
    regime_rows rows;
    uint64_t seed, count;
    int processes; /* 1 to REPORT_PROCESSES */
    bool reference; /* is to be had (truth_has_reference) */
} report_plan;

/* How many cases of the regime are asked for a `count` of the plan's. Regimes differ in what it
 * takes to see a rare fault and in what a case costs: more of camera, fewer where the truth is
 * dear. */
uint64_t report_cases(const report_plan *plan, regime which);

/* Who is held against the reference is asked so many times as many, the others' among them. */
#define REPORT_REFERENCE_CASES 3

/* Asks all of them, in so many processes at a time, then takes their times side by side, and fills
 * in all but who they are. `bar` has so many steps. Returns NULL, or what is wrong. */
#define REPORT_STEPS(count) (((count) + 1) * SURE_SHAPES)
const char *report_gather(const report_plan *plan, report_candidate *list, int count,
                          progress *bar);

/* Of each shape what certain takes a ray of the regime typical, called with one ray and with ever
 * more: docs/report.md has the fields. */
json_t *report_blocks(const report_plan *plan);

/* Two hard scenes by every tier: for each its name, its file, its size, and for each tier the
 * picture's RGB bytes in base64. NULL after a line to standard error. */
json_t *report_pictures_draw(void);

/* A whole report: who is asked, the judging, the pictures, and the files. */
typedef struct {
    const char *page, *json; /* the last may be NULL */
    bool quiet;
    report_plan plan;
    report_candidate list[REPORT_CANDIDATES]; /* of which `count` are asked */
    int count;
    const char *version, *flags; /* of the program, and what it was compiled with */
    char *const *words;          /* of the command line, behind the command; NULL ends them */
} report_run;

/* One more to be asked; there has to be room. NULL: the tier. False when there is no memory. */
bool report_add(report_run *run, sure_tier tier, const char *library);

/* Every tier, and the peers that were built with surehit. */
bool report_choose_all(report_run *run);

/* Returns 0; 1 where the output could not be written or a candidate could not be asked, after one
 * line to standard error. */
int report_make(report_run *run);

/* That line, when it is of none of the files; false. */
bool report_fail(const char *message);
