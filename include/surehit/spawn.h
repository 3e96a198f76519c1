/* SPDX-License-Identifier: MIT */
/* Where a ray that leaves a surface begins. */
#pragma once

#include <surehit/object.h>

SURE_C_BEGIN

/* The side of a solid's boundary; of a plane or disc OUTSIDE is the one the normal points to. */
typedef enum { SURE_SIDE_OUTSIDE, SURE_SIDE_INSIDE } sure_side;

/* A point next to the hit, certainly on the side asked for: outside the closed solid, in its
 * interior, or with N.(origin - Q) > 0 or < 0. A ray from there doesn't meet the surface that it
 * leaves because of a rounding (shadow acne, leaks). No epsilon: the point is found by exact tests.
 *
 * Each coordinate is at most SURE_SPAWN_STEPS doubles away from the correctly rounded coordinate of
 * the true hit point o + t* d (where that rounds to an infinity, from there).
 *
 * Entry    the hit that sure_<shape>_hit_certain or _exact returned for this ray and the object.
 * Returns  1 and *origin, finite; 0 and *origin untouched when no such point exists. Solids of
 *          radius 0 and flat boxes have no inside; solids that are thinner there than the doubles
 *          lie apart may have none that can be told by doubles. Outside, and on either side of a
 *          plane or disc, there is one unless the way to it leads beyond the greatest double.
 * Bound    SURE_SPAWN_STEPS; the same origin in every rounding mode, subnormals flushed or not. It
 *          may have subnormal coordinates, next to 0.
 * Source   docs/derivations/spawn.md
 * Proof    docs/derivations/spawn.md, docs/proofs/spawn.md
 *
 * Law 1: the side is right by exact arithmetic.
 * Law 2: within SURE_SPAWN_STEPS of the hit point; 0 only where the whole box has no such point. */
int sure_spawn(const sure_ray *ray, const sure_object *object, const sure_hit *hit, sure_side side,
               sure_vec3 *origin);

SURE_C_END
