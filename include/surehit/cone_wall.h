/* SPDX-License-Identifier: MIT */
/* The wall of a cone: both nappes, without end. */
#pragma once

#include <surehit/cone.h>

SURE_C_BEGIN

/* First point on the ray of the infinite double cone around the line base-apex: the squared
 * equation of the notes, before a nappe is chosen.
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit (part wall); SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: none; t_error = +infinity. exact: right, always, t correctly
 *          rounded, in any rounding mode, subnormals flushed or not.
 *          exact tells in hit->leaves whether the ray comes out of the double cone, the others
 *          whether t is the greater root.
 * Source   notes, "ray-cone intersection", step 1.
 * Proof    docs/derivations/cone_wall.md
 *
 * Law 1: mirroring base in the apex (the other nappe) leaves status and t.
 * Law 2: a ray along a generator hits at t_min: in exact always, in the others where a, b/2 and c
 *        are computed exactly. */
SURE_PLAIN(sure_status, sure_cone_wall_hit, const sure_ray *ray, const sure_cone *cone,
           sure_hit *hit);
sure_status sure_cone_wall_hit_exact(const sure_ray *ray, const sure_cone *cone, sure_hit *hit);

/* Where o + t_min d is: -1 inside of the double cone, 0 on the wall, 1 outside;
 * right, always. Entry: a valid ray and cone. */
int sure_cone_wall_side_exact(const sure_ray *ray, const sure_cone *cone);

SURE_C_END
