/* The page of `surehit report`: several candidates, asked the same cases and set side by side. */
#ifndef JUDGE_REPORT_H
#define JUDGE_REPORT_H

#include "../../cases/regimes.h"
#include "../tally.h"

#include <stddef.h>
#include <stdio.h>

#define REPORT_CANDIDATES 32
#define REPORT_MESSAGE 320

/* A shape and regime, as far as the page shows it. */
typedef struct {
    double nanoseconds;                     /* a ray's hit; 0: not known */
    double t_median, t_q99, t_most;         /* in ulps, of the hits that both have */
    uint32_t cases, valid, wrong, breaches; /* cases 0: not asked */
    uint32_t unasked, t_right, t_count;
    uint32_t t_classes[SIZE_CLASSES];
    bool ended; /* it crashed, hung or was out of step somewhere: its time is not taken */
} report_row;

/* What its answers are held against. */
typedef enum {
    REPORT_BY_EXACT,
    REPORT_BY_REFERENCE, /* certain and exact: CGAL, which shares nothing with them */
    REPORT_BY_LIKE       /* they, where the reference is not to be had: exact, and no evidence */
} report_truth;

typedef struct {
    const char *name;    /* "certain", "embree" */
    const char *about;   /* what it stands for, in a line */
    const char *library; /* its file; NULL: a tier of the library */
    sure_tier tier;
    report_truth truth;
    bool in_float;                /* it is asked and answers in float */
    bool with_normals;            /* it gives them with every hit: its time includes them */
    char trouble[REPORT_MESSAGE]; /* why it could not be asked; empty: it was */
    report_row rows[SURE_SHAPES][REGIMES];
} report_candidate;

typedef struct {
    bool wanted[SURE_SHAPES][REGIMES];
    uint64_t seed, count;
    int processes;
    bool reference; /* is to be had (truth_has_reference) */
} report_plan;

/* How many cases of the regime are asked for a `count` of the plan's. Regimes differ in what it
 * takes to see a rare fault and in what a case costs: more of typical, fewer where the truth is
 * dear. */
uint64_t report_cases(const report_plan *plan, regime which);

/* Who is held against the reference is asked so many times as many, the others' among them. */
#define REPORT_REFERENCE_CASES 3

/* Asks all of them, in so many processes at a time, then takes their times side by side, and fills
 * in all but who they are. `step` is told how much is done, of so many steps. False after a
 * message. */
#define REPORT_STEPS(count) (((count) + 1) * SURE_SHAPES)
typedef void report_step(void *context, int done, int of);
bool report_gather(const report_plan *plan, report_candidate *list, int count, report_step *step,
                   void *context, char message[REPORT_MESSAGE]);

/* A PNG in memory. */
typedef struct {
    unsigned char *bytes; /* NULL: none */
    size_t size;
} report_png;

/* A picture, and where it differs from the right one. */
typedef struct {
    const char *name, *note;
    report_png drawn, apart;
    int width, height;
} report_picture;

typedef struct {
    const char *title, *text; /* what it shows; text may hold HTML */
    const char *file;         /* its .rt file */
    const report_picture *pictures;
    int count;
} report_scene;

/* A scene by every tier. */
typedef struct {
    char *name;                     /* its file's, without the ending */
    uint64_t wrong[SURE_TIERS];     /* pixels that show another object than exact's do */
    double nanoseconds[SURE_TIERS]; /* of processor time, a pixel */
} report_trade_row;

typedef struct {
    report_trade_row *rows;
    int count;         /* of scenes */
    int width, height; /* of each picture */
    int rounds;        /* of timing */
} report_trade;

typedef struct {
    const char *version, *cpu, *compiler, *flags, *date;
    const char *command; /* which made the page */
    double seconds;      /* and how long it took */
    const report_scene *scenes;
    int scene_count;
    const report_trade *trade; /* without rows: nobody asked for it */
} report_setting;

/* Writes the page: HTML that needs no other file. */
void report_print(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                  const report_setting *setting);

#endif
