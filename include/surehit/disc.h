/* SPDX-License-Identifier: MIT */
/* The flat disc: the points of a plane within a radius of its centre, rim included. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 centre; /* Q: finite */
    sure_vec3 normal; /* N: finite, not zero, of any length */
    double radius;    /* r: finite, >= 0; 0 makes the disc a point */
} sure_disc;

/* The functions of <surehit/shape.h>, sure_disc_hit_certain and so on.
 *
 * Hit      the set itself; a ray inside its plane hits at the first point of its chord.
 * Normal   N/|N| as given, whichever side the ray comes from.
 * Source   notes, "top circle of the cylinder".
 * Proof    docs/derivations/disc.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(disc)

SURE_C_END
