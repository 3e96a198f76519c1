/* SPDX-License-Identifier: MIT */
/* The solid capped cylinder, stored by its two end points so that all but one root is rational. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 base; /* centre of the base cap: finite */
    sure_vec3 top;  /* centre of the top cap: finite, differs from base */
    double radius;  /* r: finite, >= 0; 0 makes the cylinder a segment */
} sure_cylinder;

/* The functions of <surehit/shape.h>, sure_cylinder_hit_certain and so on.
 *
 * Hit      wall and both caps, decided by the interval that the body and the end planes leave.
 * Normal   the outward unit normal of hit->part; on a wall of radius 0, -d/|d|.
 * Source   notes, "ray - cylinder intersection".
 * Proof    docs/derivations/cylinder.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(cylinder)

SURE_C_END
