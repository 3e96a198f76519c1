/* SPDX-License-Identifier: MIT */
/* The size of the window through which the camera looks. */
#pragma once

#include <surehit/linkage.h>

SURE_C_BEGIN

/* 2 f tan(pi/360 FOV): the extent of the viewport across which fov degrees are seen from
 * focal_length away. The notes take it for the height; a horizontal field of view gives the width.
 *
 * Entry    focal_length > 0, finite; 0 < fov < 180, degrees.
 * Returns  the extent, in the unit of focal_length.
 * Bound    none: the tangent is the C library's. The tracer's is correctly rounded.
 * Source   notes, "FOV".
 * Proof    docs/derivations/viewport.md
 *
 * Law 1: focal_length -> 2^k focal_length scales the extent by 2^k.
 * Law 2: the extent grows with fov. */
SURE_TIERED(double, sure_viewport_extent, double focal_length, double fov);

SURE_C_END
