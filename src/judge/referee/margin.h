/* SPDX-License-Identifier: MIT */
/* How far from right a wrong decision is (docs/judge.md, "Margins"): the faces of the object may
 * move by so much, and it is wrong still. Each step is a question to the tier exact. */
#pragma once

#include "../../cases/moved.h"
#include "../verdict/tally.h"

/* What a margin is told in. */
typedef enum {
    MARGIN_NONE,
    MARGIN_SIZE,     /* half of the object's largest extent; of a plane the distance */
    MARGIN_DISTANCE, /* from the ray's start to the object's first point, and the size */
    MARGIN_LENGTH,   /* the scene's unit */
    MARGIN_ULPS,     /* the distance between neighbours of the largest coordinate */
    MARGIN_GROWTH    /* of each face its own: its distance from the object's middle */
} margin_unit;

/* "size", ..., NULL at the end. */
extern const char *const margin_unit_names[];

/* The unit as a length, of that case; of MARGIN_GROWTH there is none. */
double margin_length(const sure_case *question, margin_unit unit, precision in);

/* The way of each face at the margin 1. */
movement margin_way(const sure_case *question, margin_unit unit, precision in);

/* A false hit, a false miss or a wrong part, as it was answered. */
fault margin_fault(unsigned faults);

/* Is the answer wrong for each object, too, whose faces are at most that way from where they are?
 * Entry: the fault is one of the above, no way is negative; where one is 0 it is not told. */
bool margin_beyond(const sure_case *question, fault which, const reply *given, const movement *way);

/* Each face by the same length. */
bool margin_beyond_length(const sure_case *question, fault which, const reply *given, double by);

/* Does it depend on the faces, moved by at most that length, by which end of the object a right ray
 * that hits it does? For it starts within that length of its boundary. Never of a flat object. */
bool margin_of_end(const sure_case *question, double by);

/* The largest part or multiple of the unit beyond which it is, to one part in 16, from `least`,
 * which it is beyond, to `below`, which it is not (infinite: not known). Where that is not more
 * than `enough`, some number that is not. */
#define MARGIN_MOST 0x1p10
double margin_of(const sure_case *question, fault which, const reply *given, double least,
                 double below, double enough, const movement *unit);
