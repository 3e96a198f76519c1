/* SPDX-License-Identifier: MIT */
/* What the heights' stages tell of any plane. */
#pragma once

#include <surehit/vector.h>

/* On which side of the plane through `at` p is, exactly: 1 where its normal, to - from, points to,
 * 0 on it, -1 beyond. Entry: finite. */
int part_plane_side(sure_vec3 from, sure_vec3 to, sure_vec3 at, sure_vec3 p);
