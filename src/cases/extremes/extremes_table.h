/* What each tier makes of the extreme cases. */
#ifndef CASES_EXTREMES_TABLE_H
#define CASES_EXTREMES_TABLE_H

#include <stdint.h>
#include <stdio.h>

/* Asks every tier the first `count` members of every family (extremes.h) and prints the table of
 * its answers. Returns 0, or nonzero when it could not be printed. */
int extremes_table(FILE *out, uint64_t count);

#endif
