/* SPDX-License-Identifier: MIT */
/* A manifest: what is to be asked, in pieces that take equally long, and each of them worked off.
 *
 * Sealed lines, the first as in record.h, then a line a piece, in their order from 1 on:
 *
 *     {"piece":1,"seconds":597.3,"cases":[{"shape":"cone","regime":"bits","ranges":[[0,8333]]}]} */
#pragma once

#include "record.h"

/* `cases` of all pairs together that are wanted, as many of each or a sixth where answers are
 * longest; of each the first ones that `after` does not have. In so many pieces, or, where that is
 * 0, in pieces of some `seconds`. */
typedef struct {
    const campaign_truth *against;
    uint64_t seed;
    double cases, seconds;
    uint64_t pieces;
    int shape, regime; /* -1: all */
    const campaign_record *after;
} plan_wish;

/* Measures what cases take, writes the manifest. Unless it is, one line was written to
 * `messages`. */
typedef enum { PLAN_WRITTEN = 0, PLAN_NOT_WRITTEN = 1, PLAN_IMPOSSIBLE = 2 } plan_state;
plan_state plan_write(const plan_wish *wish, const char *path, FILE *messages);

typedef struct {
    manifest of;
    const campaign_truth *against;
    uint64_t seed;
} plan;

/* One that this very program can work off, to be freed by manifest_free. On false one line was
 * written to `messages`, and nothing is left allocated. */
bool plan_read(const char *path, FILE *messages, plan *read);

/* The cases of a piece, to be freed. On false one line was written to `messages`. */
bool plan_piece(const plan *by, size_t number, FILE *messages, coverage *cases);

/* Which part of the piece is done in the folder? 1: all. Less than 0: what is there is another
 * plan's, or another piece's. What is there and is no result of it gets a line to `messages`. */
double piece_done(const plan *by, size_t number, const coverage *cases, const char *folder,
                  FILE *messages);

/* Works a piece off that is not done, and not others': FOLDER/NUMBER.json appears when all of it is
 * done, and what was done after every `keep` seconds of the processor, and after `limit` of them
 * (0: any), in FOLDER/NUMBER.part, from where another call goes on. A crash, and a case without an
 * end, end the program with a line that names the case. On false one line was written to
 * `messages`. */
bool piece_work(const plan *by, size_t number, const coverage *cases, const char *folder,
                double keep, unsigned long limit, FILE *messages);
