/* SPDX-License-Identifier: MIT */
/* Rotation about the coordinate axes. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

/* R_x, R_y, R_z: v turned by an angle (radians) about one axis, right-handed: R_x takes +y to +z,
 * R_y takes +z to +x, R_z takes +x to +y.
 *
 * Entry    finite.
 * Returns  the turned vector.
 * Bound    none: cosine and sine are the C library's.
 * Source   notes, "formula for rotation".
 * Proof    docs/derivations/rotation.md
 *
 * Law 1: the coordinate of the axis is kept exactly; an angle of 0 changes nothing.
 * Law 2: turning back by the negative angle gives v up to rounding; a unit vector across the axis
 *        comes back as cos^2 + sin^2 as rounded, and 0.
 * Law 3: R_y and R_z are R_x with the coordinates exchanged cyclically. */
SURE_TIERED(sure_vec3, sure_rotate_x, double angle, sure_vec3 v);
SURE_TIERED(sure_vec3, sure_rotate_y, double angle, sure_vec3 v);
SURE_TIERED(sure_vec3, sure_rotate_z, double angle, sure_vec3 v);

/* M v, for matrices whose entries come from a vector's components and not from an angle.
 * Entry: any numbers. Where a row of M, or v, is not finite, neither is that coordinate of M v. */
SURE_TIERED(sure_vec3, sure_rotation_apply, const sure_mat3 *matrix, sure_vec3 v);

/* M^T v: of a rotation or a mirrored one the way back, but for roundings. Entry: likewise,
 * of columns. */
SURE_TIERED(sure_vec3, sure_rotation_undo, const sure_mat3 *matrix, sure_vec3 v);

SURE_C_END
