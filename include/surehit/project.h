/* SPDX-License-Identifier: MIT */
/* The projection of one vector on another. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

/* proj_N V = (N.V / N.N) N, the part of v along n.
 *
 * Entry    finite; n not zero, of any length; but for stable, |n|^2, n.v and n.v / |n|^2 neither
 *          over- nor underflow.
 * Returns  the projection.
 * Bound    none.
 * Source   notes, "Perfect Reflection".
 * Proof    docs/derivations/project.md
 *
 * Law 1: the projection of c n on n, c and n small integers, is c n.
 * Law 2: n -> 2^k n and n -> -n change nothing; v -> 2^k v scales the result by 2^k, while nothing
 *        underflows.
 * Law 3: a v whose n.v is computed as 0 projects to zero. */
SURE_TIERED(sure_vec3, sure_project, sure_vec3 v, sure_vec3 n);

SURE_C_END
