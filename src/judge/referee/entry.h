/* SPDX-License-Identifier: MIT */
/* Entry conditions: what a candidate says of the cases that it can be asked, and of what it answers
 * by other conventions than the contract (docs/judge.md, "Entry conditions"). */
#pragma once

#include "event.h"

#include <stdbool.h>

typedef struct {
    bool declared; /* anything is */

    /* The case is made so; what that rounds is part of the case that is asked. */
    bool unit;      /* |d| is 1 */
    bool aligned;   /* axis or normal along a coordinate axis */
    bool local;     /* along +z, and the object's first point in the origin */
    bool centred;   /* the same with the middle of what has two points in the origin */
    bool from_zero; /* t_min is 0 */
    bool ray;       /* t_min is 0 and t_max infinite */
    bool segment;   /* t_min is 0 and t_max finite */
    bool square;    /* the radius' square has no rounding */
    bool in_float;

    /* What is not so isn't asked. */
    bool line;          /* nothing of the object lies behind the start of the range */
    bool outside;       /* the range starts off the closed object ... */
    double apart;       /* ... or farther than so many of its sizes from its boundary */
    double least, most; /* of sizes, and |o - c| is at most that, too; 0: any */

    /* What is judged otherwise. */
    bool decision; /* t isn't told */
    bool wall;     /* of a cylinder or a cone the infinite wall is meant; no normal is judged */
    bool misses[EVENTS]; /* a hit in such an event may be a miss, */
    bool zero_inside;    /* and from inside t may be t_min */
} entry;

/* Words, separated by blanks or commas; NULL and *all, or what was expected instead. */
const char *entry_read(const char *text, entry *all);

/* Of a query: of a point there is no range, and of the chord no start. */
entry entry_for(const entry *all, query asks);

/* The case as such a candidate receives it; false: it can't be asked. */
bool entry_case(const entry *all, const sure_case *question, precision in, sure_case *received);

/* The same for a query. Of QUERY_INSIDE it is about the point of the first hit, as rounded, or,
 * where there is none, the ray's start: the start of a ray along x that goes nowhere. */
bool entry_query(const entry *all, query asks, const sure_case *question, precision in,
                 sure_case *received);

/* Is the ray what entry_query makes of a point, or no point asked for? */
bool entry_is_query(query asks, const sure_case *question);

/* Is it such a case? */
bool entry_holds(const entry *all, const sure_case *question, precision in);

/* Is the faulty answer right by the candidate's conventions? */
bool entry_allows(const entry *all, event which, const sure_case *question, fault of,
                  const reply *given);
