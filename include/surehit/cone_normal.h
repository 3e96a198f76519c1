/* SPDX-License-Identifier: MIT */
/* The normal of a cone by its slant length. */
#pragma once

#include <surehit/cone.h>

SURE_C_BEGIN

/* The outward unit normal at a point of the wall: from S, the point of the axis at |PQ| /
 * cos(theta) from the apex Q, to P. Zero where P and S coincide (the wall of radius 0) or the way
 * overflows; at the apex the direction from base to apex.
 *
 * Entry    a valid cone, a finite point.
 * Returns  the normal.
 * Bound    none.
 * Source   notes, "ray-cone intersection", step 2; the printed Q + PQ / cos(theta) N is an erratum.
 * Proof    docs/derivations/cone_normal.md
 *
 * Law 1: the normal is at right angles to the generator through the point, up to rounding, while
 *        nothing underflows.
 * Law 2: likewise two points of one generator have one normal, up to rounding; exactly when they
 *        differ by a power of two as seen from an apex in the origin. */
SURE_PLAIN(sure_vec3, sure_cone_wall_normal, sure_vec3 point, const sure_cone *cone);

SURE_C_END
