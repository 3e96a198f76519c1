/* The record of digests: one row for each block of cases of a regime of a shape. */
#ifndef TESTS_FROZEN_RECORD_H
#define TESTS_FROZEN_RECORD_H

#include "answers.h"

#include <stdbool.h>

/* Block 0 has 2048 cases, and each block after it as many as all before. The costly regimes have
 * fewer blocks. */
#define BLOCKS 7
#define ROWS (SURE_SHAPES * REGIMES * BLOCKS)

uint64_t block_begin(int block);
uint64_t block_end(int block);
int blocks_of(regime which);

typedef struct {
    sure_shape shape;
    regime which;
    int block;
    bool known; /* digests are of the record */
    uint64_t digests[COLUMNS];
} record_row;

typedef struct {
    int count;
    record_row rows[ROWS];
} record;

/* Fills in a row for every block that there is, none of them known. */
void record_lay_out(record *all);

/* Reads the digests. False, and one line to stderr, for a file that can't be read or has a row that
 * is not in `all` or is there twice. */
bool record_read(record *all, const char *path);

/* Writes the rows that are known. False, and one line to stderr, if it can't. */
bool record_write(const record *all, const char *path);

#endif
