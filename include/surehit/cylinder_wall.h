/* SPDX-License-Identifier: MIT */
/* The wall of a cylinder, without ends. */
#pragma once

#include <surehit/cylinder.h>

SURE_C_BEGIN

/* First point of the infinite wall around the line base-top on the ray: roots of D/4 and, for a ray
 * along the wall, t_min.
 *
 * Entry    any values; what the contract calls invalid is answered SURE_INVALID.
 * Returns  SURE_HIT and *hit (part wall); SURE_MISS or SURE_INVALID and *hit untouched.
 * Bound    float32, textbook: none; t_error = +infinity. exact: right, always, t correctly
 *          rounded, in any rounding mode, subnormals flushed or not.
 *          exact tells in hit->leaves whether the ray comes out of the body, the others whether t
 *          is the greater root.
 * Source   notes, "ray - cylinder intersection", step 1.
 * Proof    docs/derivations/cylinder_wall.md
 *
 * Law 1: exchanging base and top, or moving both along the axis, leaves status and t (exactly, on
 *        integers with a power of two for the squared axis length).
 * Law 2: a ray parallel to the axis hits if and only if it lies in the wall: in exact always, in
 *        the others where a and c are computed exactly. */
SURE_PLAIN(sure_status, sure_cylinder_wall_hit, const sure_ray *ray, const sure_cylinder *cylinder,
           sure_hit *hit);
sure_status sure_cylinder_wall_hit_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                         sure_hit *hit);

/* Where o + t_min d is: -1 inside of the infinite cylinder, 0 on the wall, 1 outside;
 * right, always. Entry: a valid ray and cylinder. */
int sure_cylinder_wall_side_exact(const sure_ray *ray, const sure_cylinder *cylinder);

/* The unit vector from the foot of the point on the axis to the point.
 *
 * Entry    a valid cylinder, a finite point.
 * Returns  the vector; zero where the way is computed as zero or overflows. For a point of the axis
 *          roundings may leave a way that is not zero: then it is a unit vector of any direction.
 *          So it is, or zero, where |top - base|^2, (top - base).(point - base) or their quotient
 *          over- or underflows.
 * Bound    none.
 * Source   notes, "ray - cylinder intersection", step 2.
 * Proof    docs/derivations/cylinder_wall.md */
SURE_PLAIN(sure_vec3, sure_cylinder_wall_normal, sure_vec3 point, const sure_cylinder *cylinder);

SURE_C_END
