/* SPDX-License-Identifier: MIT */
/* The end of a cone, and the nappe that is kept. */
#pragma once

#include <surehit/cone.h>

SURE_C_BEGIN

/* The base centre and the apex C -+ h/2 N/|N| of a cone given by its middle, its axis (from base to
 * apex) and its height.
 *
 * Entry    finite; axis not zero, of any length; radius >= 0, height > 0.
 * Returns  SURE_FIELD_NONE and *cone; otherwise the first bad field and *cone untouched: centre;
 *          normal for the axis; apex for a height that is not positive, or end points that are not
 *          finite or collapse into one; radius.
 * Bound    SURE_END_POINT_ULPS, per component (textbook); float32: none.
 * Source   notes, "ray-cone intersection", step 1.
 * Proof    docs/derivations/cone_height.md
 *
 * Law 1: axis -> -axis exchanges base and apex, bit for bit.
 * Law 2: axis -> 2^k axis changes no bit while nothing underflows. */
SURE_PLAIN(sure_field, sure_cone_from_axis, sure_vec3 centre, sure_vec3 axis, double radius,
           double height, sure_cone *cone);

/* Does a point of the double cone belong to this cone: |point - apex|^2 <= r^2 + h^2 and
 * N.(apex - point) >= 0?
 *
 * Entry    a valid cone, a finite point.
 * Returns  1 or 0.
 * Bound    float32, textbook: as their precision has it; certain, exact: right, always, in any
 *          rounding mode, subnormals flushed or not.
 * Source   notes, "ray-cone intersection", step 1; the printed rq.PQ >= 0 is an erratum.
 * Proof    docs/derivations/cone_height.md, docs/proofs/height.md
 *
 * Law 3: apex and base themselves belong to it; in the plain tiers while nothing overflows.
 * Law 4: a greater radius never turns 1 into 0.
 * Law 5: scaling point and cone by 2^k changes nothing; in the plain tiers while nothing over- or
 *        underflows.
 * Law 6: negating one coordinate of everything, or exchanging x and y, changes nothing. */
SURE_PLAIN(int, sure_cone_height, sure_vec3 point, const sure_cone *cone);
int sure_cone_height_certain(sure_vec3 point, const sure_cone *cone);
int sure_cone_height_exact(sure_vec3 point, const sure_cone *cone);

SURE_C_END
