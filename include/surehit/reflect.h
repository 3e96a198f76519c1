/* SPDX-License-Identifier: MIT */
/* Perfect reflection: a metallic surface. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

/* R = 2 proj_N V - V: v mirrored in n, both pointing away from the surface.
 *
 * Entry    finite; n not zero, of any length; but for stable, |n|^2, n.v and n.v / |n|^2 neither
 *          over- nor underflow.
 * Returns  the mirrored vector; its length is |v| up to rounding.
 * Bound    none.
 * Source   notes, "Perfect Reflection"; the printed 2 (proj_N V - V) is an erratum.
 * Proof    docs/derivations/reflect.md
 *
 * Law 1: v along n is its own mirror image, v at right angles to n turns into -v: exactly on
 *        integers for which |n|^2 is a power of two, up to rounding elsewhere.
 * Law 2: n -> 2^k n and n -> -n change nothing.
 * Law 3: on integers for which |n|^2 is a power of two the mirror image of the mirror image is v,
 *        and n.R = n.v, both exactly. */
SURE_TIERED(sure_vec3, sure_reflect, sure_vec3 v, sure_vec3 n);

SURE_C_END
