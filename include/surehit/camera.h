/* SPDX-License-Identifier: MIT */
/* The camera stays and the world is moved. */
#pragma once

#include <surehit/answer.h>
#include <surehit/vector.h>

SURE_C_BEGIN

/* The rotation of the world after which a camera that looked along `view` looks along (0,0,-1):
 * R_x R_y, with entries computed from the components (axis cases are exactly 0 and +-1). Straight
 * up and down the roll is that of a camera at (0, y, z) with z -> -0.
 *
 * Entry    finite, not zero, of any length.
 * Returns  SURE_HIT and *world; SURE_INVALID (view, as the tier has it, zero or not finite) and
 *          *world untouched.
 * Bound    none.
 * Source   notes, "set camera vector", eight cases; the general one is derived.
 * Proof    docs/derivations/camera.md
 *
 * Law 1: the eight listed cases give the notes' corrected matrices, the axis cases exactly.
 * Law 2: view -> 2^k view changes no bit.
 * Law 3: mirroring view in x mirrors the matrix (row and column x change sign).
 * Law 4: any view's matrix is a rotation: rows at right angles, of length 1 and turning right. It
 *        takes the view to (0,0,-|view|). Up to rounding.
 * Law 5: verticals stay vertical and up stays up: row 0's y is 0, row 1's is not below 0. */
SURE_TIERED(sure_status, sure_camera_rotation, sure_vec3 view, sure_mat3 *world);

SURE_C_END
