/* SPDX-License-Identifier: MIT */
/* The solid sphere. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 centre; /* C: finite */
    double radius;    /* r: finite, >= 0; 0 makes the sphere a point */
} sure_sphere;

/* The functions of <surehit/shape.h>, sure_sphere_hit_certain and so on.
 *
 * Hit      from inside, the far side; tangency is a hit.
 * Normal   the outward unit normal at the hit; on a sphere of radius 0, -d/|d|.
 * Source   notes, "ray - sphere intersection".
 * Proof    docs/derivations/sphere.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(sphere)

SURE_C_END
