/* SPDX-License-Identifier: MIT */
/* A judgement while it is made: what judging.c and judging_given.c share. */
#pragma once

#include "judging.h"

#include "../support/progress.h"

/* What belongs to a row while it is made. */
typedef struct {
    int which; /* the regime, or JUDGING_GIVEN */
    entry entry;
    tally counted;
    refereed looked_at;
    judging_times times; /* of all rays that were timed: so many */
    uint64_t rays, blocks;
    block asked;
    uint64_t number; /* of the next case, and of those of the block */
    uint64_t numbers[BLOCK_CASES];
    bool has_lengths;
    camera_lengths lengths[BLOCK_CASES]; /* of the cases of pictures */
} ledger;

struct judging {
    const judging_plan *plan;
    candidate *asked;
    candidate absent; /* who it is where the answers come from the lines of this file, */
    FILE *answers;    /* else NULL; the next one, to the last case: */
    bool (*read_answer)(judging *self, reply *given, char *message);
    uint64_t answers_read;
    truth known;
    case_answer right[BLOCK_CASES];
    ledger *ledgers[QUERIES][SURE_SHAPES][JUDGING_ROWS]; /* of rows that are begun */
    const ledger *last;                                  /* whose cases were asked */

    /* Takes the times of a block that was asked, or NULL. The tiers for theirs: each runs in a
     * process of its own and is called and timed as a shared library is (plugin.h). */
    void (*take_times)(judging *self, ledger *of);
    candidate *tiers[SURE_TIERS][2][2]; /* with normals, in floats; opened when they are needed */
    rng order;
    block room;

    progress *bar; /* of cases, or of bytes of their file; or NULL */
};

/* A file of lines, "-": standard input; NULL after a message. */
FILE *judging_input(const char *name, char *message);

/* The next line of the file of answers. */
bool judging_read_answer(judging *self, reply *given, char *message);

/* The row's, begun where it wasn't; NULL after a message. Zeros take no memory until something is
 * counted there. */
ledger *ledger_of(judging *self, query asks, sure_shape shape, int which, char *message);

/* One more case; a block that is full is judged. False after a message. */
bool ledger_add(judging *self, ledger *of, const sure_case *question, char *message);

/* Judges made cases first .. end - 1 of a regime. False after a message. */
bool ledger_judge(judging *self, ledger *of, uint64_t first, uint64_t end, char *message);

/* The row, and the end of its ledger. False after a message. */
bool ledger_finish(judging *self, ledger *of, judging_row *row, char *message);
