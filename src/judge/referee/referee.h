/* SPDX-License-Identifier: MIT */
/* Wrong decisions looked at once more: what the candidate's conventions allow, and how far off the
 * rest is. */
#pragma once

#include "entry.h"
#include "margin.h"

/* Sizes of margins that are told, in the unit, ascending. */
#define MARGINS_MOST 24
typedef struct {
    margin_unit unit;
    int count;
    double list[MARGINS_MOST];
} margins;

/* Those of every verdict, of that unit. */
margins margins_of(margin_unit unit);

/* One more; false: there is no room. */
bool margins_add(margins *all, double size);

enum { FAULTS_WITH_MARGIN = FAULT_WRONG_PART + 1 };

/* Of all wrong decisions of a row. */
typedef struct {
    uint64_t allowed[EVENTS];           /* by a convention */
    uint64_t events[EVENTS];            /* of those that are left */
    uint64_t beyond[MARGINS_MOST];      /* ... wrong by more than that margin */
    double most[FAULTS_WITH_MARGIN];    /* the largest margin of each fault, in the unit, or 0, */
    example widest[FAULTS_WITH_MARGIN]; /* and its case */
} refereed;

/* The example's faults, without those that are allowed; they are counted. */
unsigned referee(refereed *sum, const margins *told, const entry *by, precision in,
                 const example *one);

/* Where t lawfully is the start of the range, it is the right one; of walls no normal is judged. */
void referee_take_t(const entry *by, example *one);

/* The faults alone. */
unsigned faults_by_entry(const entry *by, const example *one);

/* The largest of all. */
double refereed_most(const refereed *sum);
