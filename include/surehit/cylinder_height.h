/* SPDX-License-Identifier: MIT */
/* The ends of a cylinder. */
#pragma once

#include <surehit/cylinder.h>

SURE_C_BEGIN

/* The end points C -+ h/2 N/|N| of a cylinder given by its middle, its axis and its height.
 *
 * Entry    finite; axis not zero, of any length; radius >= 0, height > 0.
 * Returns  SURE_FIELD_NONE and *cylinder; otherwise the first bad field and *cylinder untouched:
 *          centre; normal for the axis; top for a height that is not positive, or end points that
 *          are not finite or collapse into one; radius.
 * Bound    SURE_END_POINT_ULPS, per component (textbook); float32: none.
 * Source   notes, "ray - cylinder intersection", step 2.
 * Proof    docs/derivations/cylinder_height.md
 *
 * Law 1: axis -> -axis exchanges base and top, bit for bit.
 * Law 2: axis -> 2^k axis changes no bit while nothing underflows. */
SURE_PLAIN(sure_field, sure_cylinder_from_axis, sure_vec3 centre, sure_vec3 axis, double radius,
           double height, sure_cylinder *cylinder);

/* Is the point between the end planes, ends included: N.(point - top) <= 0 <= N.(point - base)?
 *
 * Entry    a valid cylinder, a finite point.
 * Returns  1 or 0.
 * Bound    float32, textbook: as their precision has it; certain, exact: right, always, in any
 *          rounding mode, subnormals flushed or not.
 * Source   notes, "ray - cylinder intersection", step 2.
 * Proof    docs/derivations/cylinder_height.md, docs/proofs/height.md
 *
 * Law 3: base and top themselves are between the end planes; in the plain tiers while top - base
 *        does not overflow.
 * Law 4: exchanging base and top changes nothing, nor does the radius.
 * Law 5: scaling point and cylinder by 2^k changes nothing; in the plain tiers while nothing over-
 *        or underflows.
 * Law 6: negating one coordinate of everything, or exchanging x and y, changes nothing. */
SURE_PLAIN(int, sure_cylinder_height, sure_vec3 point, const sure_cylinder *cylinder);
int sure_cylinder_height_certain(sure_vec3 point, const sure_cylinder *cylinder);
int sure_cylinder_height_exact(sure_vec3 point, const sure_cylinder *cylinder);

SURE_C_END
