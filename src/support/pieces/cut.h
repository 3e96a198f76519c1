/* SPDX-License-Identifier: MIT */
/* A command's long work in pieces: `surehit plan`, `work` and `merge` run the command itself, by
 * the words that were planned, and here it learns how much of its work it is to do.
 *
 * Manifests and results are sealed lines. The first one of both says what is asked and by whom:
 *
 *     {"surehit pieces":1,"words":["render","a.rt","--size","640x360"],
 *      "sources":"0123456789abcdef","compiler":"gcc 12.2.0","flags":"...",
 *      "architecture":"x86_64","squares":920,"inputs":{"a.rt":"0123456789abcdef"}}
 *
 * A manifest's pieces follow, {"piece":1,"ranges":[[0,8]]}; in a result the ranges that are done,
 * {"ranges":[[0,8]]}, and a line of the command's own. Ranges are of numbered parts of the work,
 * each the first one and how many. Of one set of parts there is one file. */
#pragma once

#include "manifest.h"
#include "ranges.h"

/* A file that the work depends on. */
typedef struct {
    const char *path;
    uint64_t hash; /* of the bytes that were read */
} cut_input;

/* The work of a command. */
typedef struct {
    const char *unit; /* what its parts are, "squares" */
    uint64_t total;   /* parts, from 0 on */
    cut_input input;  /* path NULL: none */
    void *sum;        /* of what is done, at first of nothing */
    /* Does these, in their order, and asks cut_goes_on now and then, or cut_is_due and then that.
     * False after a line to standard error. */
    bool (*work)(void *sum, index_range some);
    /* What came of them; NULL: no memory. */
    json_t *(*tell)(const void *sum, const index_ranges *done);
    /* Adds what was told of others. Returns what is wrong, or NULL. */
    const char *(*add)(void *sum, const index_ranges *done, const json_t *told);
} cut_work;

/* What is to be done of it: all, by the command alone; none, but a manifest is written; a piece;
 * none, but results are added. */
typedef enum { CUT_NOT, CUT_PLAN, CUT_WORK, CUT_MERGE } cut_way;

typedef struct {
    cut_way way;
    json_t *asked; /* the first line as far as it is known */
    /* PLAN */
    const char *manifest;
    uint64_t pieces;
    /* WORK */
    manifest of;
    size_t number;
    const char *folder;
    double keep; /* seconds of the processor, as allowance_of has them */
    uint64_t limit;
    /* MERGE */
    const folder_listing *results;
} cut_request;

/* By the words of the one command that there is. */
extern cut_request cut;

/* Does what is asked. CUT_GOES_ON: the command goes on to its end, and has to do the work itself
 * where nothing was cut; else all of it is in the sum. Other values are exit statuses: 0; 1 after a
 * line to standard error: it could not be done; 2 likewise: what was asked for is wrong. */
#define CUT_GOES_ON (-1)
int cut_do(const cut_work *work);

/* All before `end` are done, and in the sum. False: no more of them. */
bool cut_goes_on(uint64_t end);

/* Had it better be asked? From any thread. */
bool cut_is_due(void);

/* Which part of the piece is done in the folder; 1: all. What is there and is no result of it gets
 * a line to standard error; less than 0: it is others', and not to be lost. */
double cut_done(const manifest *of, size_t number, const char *folder);
