/* SPDX-License-Identifier: MIT */
/* The infinite plane. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 point;  /* Q: finite, any point of the plane */
    sure_vec3 normal; /* N: finite, not zero, of any length */
} sure_plane;

/* The functions of <surehit/shape.h>, sure_plane_hit_certain and so on.
 *
 * Hit      the set itself; a ray inside the plane hits at t_min.
 * Normal   N/|N| as given, whichever side the ray comes from.
 * Source   notes, "ray-plane intersection".
 * Proof    docs/derivations/plane.md, docs/proofs/stages.md; what the notes print wrong,
 *          docs/errata.md.
 * Laws     1 to 9 of <surehit/shape.h>. */
SURE_SHAPE_FUNCTIONS(plane)

SURE_C_END
