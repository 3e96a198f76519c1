/* SPDX-License-Identifier: MIT */
/* The projection of one vector on another. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

/* proj_N V = (N.V / N.N) N, the part of v along n.
 *
 * Entry    finite; n not zero, of any length; but for stable, |n|^2 and n.v neither over- nor
 *          underflow.
 * Returns  the projection.
 * Bound    none.
 * Source   notes, "Perfect Reflection".
 * Proof    docs/derivations/project.md
 *
 * Law 1: the projection of c n on n, c and n small integers, is c n.
 * Law 2: n -> 2^k n and n -> -n change nothing; v -> 2^k v scales the result by 2^k.
 * Law 3: a v at right angles to n (n.v = 0 exactly) projects to zero. */
SURE_TIERED(sure_vec3, sure_project, sure_vec3 v, sure_vec3 n);

SURE_C_END
