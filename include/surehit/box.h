/* SPDX-License-Identifier: MIT */
/* The solid box, its faces across the axes. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 low;  /* the corner of the least coordinates: finite */
    sure_vec3 high; /* that of the greatest: finite, none below low's; an equal one makes it flat */
} sure_box;

/* The functions of <surehit/shape.h>, sure_box_hit_certain and so on.
 *
 * Hit      from inside, the far side; an edge that is touched is a hit.
 * Normal   the outward unit normal of the face that is hit.
 * Source   the intersection of slabs (Kay and Kajiya 1986); the notes have no box.
 * Proof    docs/proofs/box.md, docs/proofs/stages.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(box)

SURE_C_END
