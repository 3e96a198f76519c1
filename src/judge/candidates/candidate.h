/* SPDX-License-Identifier: MIT */
/* A routine to be judged, wherever it is: one of the library's tiers, a shared library, or a
 * program that reads case lines and writes answer lines. */
#pragma once

#include "../referee/entry.h"

/* The most cases that are asked at once. */
#define BLOCK_CASES 4096

/* Cases of one shape, and what the candidate says to them. */
typedef struct {
    sure_shape shape;
    query asks;
    int count;
    sure_case cases[BLOCK_CASES];
    reply replies[BLOCK_CASES];
    bool for_time;      /* the times of others on it will be taken too */
    double nanoseconds; /* for all; 0 where it is not known, and of a tier */
    double building;    /* of their objects, apart, where they are prepared; 0 likewise */
    bool with_normals;  /* in that time */
} block;

/* Who it is, in its own words; "" where it says nothing. */
typedef struct {
    char name[128], version[64], build[256];
} identity;

/* What came of asking a process: unless it answered, how it ended, the case that seems to be to
 * blame (-1: none does), and whether it surely is. */
typedef struct {
    reply_kind kind;
    int ended; /* as waitpid tells */
    int blamed;
    bool surely;
} candidate_end;

/* Since the last candidate_forgive. */
typedef struct {
    int crashes, hangs, answered;
    double cost;  /* seconds that blocks took in which it crashed, */
    double since; /* and when that of now began; 0: it did not crash in it */
} candidate_ends;

typedef struct candidate candidate;
struct candidate {
    int block_cases; /* the most that a process is asked at once, <= BLOCK_CASES */
    bool answers[QUERIES][SURE_SHAPES]; /* which queries of which shapes it answers */
    precision answers_in[QUERIES][SURE_SHAPES];
    entry entry; /* conditions that it has declared, or that were for it */
    identity who;
    bool is_program;   /* its time is that of reading and writing too; a start costs much */
    bool is_tier;      /* its time is taken of its functions beside it: hits alone */
    bool is_quick;     /* it is at hand: no program is started each time it is asked */
    double time_limit; /* seconds for the answer to a case, and for what crashes cost in a row */
    candidate_ends ends;
    /* Asks cases first .. first + count - 1 once more; adds to the block's time. */
    candidate_end (*ask)(candidate *self, block *asked, int first, int count);
    void (*close)(candidate *self);
};

/* As it takes: by the functions that it has. */
typedef enum { INPUTS_FLOAT, INPUTS_DOUBLE, INPUTS_AS_IT_TAKES } candidate_inputs;

/* Seconds for the answer to a case, where nothing else is said. */
#define CANDIDATE_TIME_LIMIT 5

/* Where asking takes place. */
typedef struct {
    candidate_inputs inputs;
    double time_limit; /* the same, as it is said */
    const char *entry; /* conditions in words (entry.h), in the place of its own; NULL */
    bool once;         /* a program is trusted: it is asked every case once */
    bool keep;         /* a program is kept running */
} candidate_options;

/* Large enough for any message below. */
#define CANDIDATE_MESSAGE 512

/* Writes it, unless it is not wanted (NULL); false. */
__attribute__((format(printf, 2, 3))) bool complain(char *message, const char *format, ...);

/* NULL after a message: what is wrong, in a line without its end. A tier runs as if a shared
 * library defined its functions, for the hits alone or with their normals. */
candidate *candidate_of_tier(sure_tier tier, bool with_normals, const candidate_options *how,
                             char *message);
candidate *candidate_of_library(const char *path, const candidate_options *how, char *message);
candidate *candidate_of_command(const char *command, const candidate_options *how, char *message);

/* Seconds for a library to be loaded, or a kept program to be ready: that is no answer's time. */
double candidate_start_limit(const candidate *self);

/* A program that speaks as docs/coprocess.md says. */
candidate *candidate_of_kept(const char *command, const candidate_options *how, char *message);

/* One that is asked by lines, of any shape; its functions are still missing. */
candidate candidate_by_lines(const candidate_options *how);

/* Fills in all replies, whatever becomes of the candidate: every case is asked twice, the second
 * time in another order, and the answers are compared (a tier's, where nothing can be remembered,
 * only where its time is taken). The rest stays unasked, until it is forgiven, after two hangs or
 * many crashes: where these are more than the answers, or take longer than the time limit. */
void candidate_ask(candidate *self, block *asked);
/* What its replies answer when it is asked: of who only decides, not where. */
query candidate_tells(const candidate *self, query asked);

void candidate_forgive(candidate *self);

/* So many took longer than the limit, but none of them alone: fewer are asked at once from now on.
 */
void candidate_is_slow(candidate *self, block *asked, int count);

void candidate_close(candidate *self);
