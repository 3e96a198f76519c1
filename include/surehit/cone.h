/* SPDX-License-Identifier: MIT */
/* The solid capped cone, stored by the centre of its base and its apex. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 base; /* centre of the base disc: finite */
    sure_vec3 apex; /* finite, differs from base */
    double radius;  /* r of the base disc: finite, >= 0; 0 makes the cone a segment */
} sure_cone;

/* The functions of <surehit/shape.h>, sure_cone_hit_certain and so on.
 *
 * Hit      wall and base disc, decided by the interval on the kept nappe.
 * Normal   the outward unit normal of hit->part; at the apex the direction from base to apex;
 *          elsewhere on a wall of radius 0, -d/|d|.
 * Source   notes, "ray-cone intersection".
 * Proof    docs/derivations/cone.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(cone)

SURE_C_END
