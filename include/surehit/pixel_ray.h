/* SPDX-License-Identifier: MIT */
/* The ray from the eye through a pixel. */
#pragma once

#include <surehit/ray.h>

SURE_C_BEGIN

/* The eye and the window in front of it, looking along (0,0,-1) with +x right and +y up. */
typedef struct {
    sure_vec3 position;                                   /* of the eye */
    double focal_length, viewport_width, viewport_height; /* > 0, finite, one unit of length */
} sure_camera;

/* The ray from the camera's position through the centre of pixel (column, row): column 0 is left,
 * row 0 is the lowest. Its direction ends on the viewport and is not normalised, so t counts
 * view-plane distances; t in [0, +infinity].
 *
 * Entry    0 <= column < width, 0 <= row < height.
 * Returns  the ray.
 * Bound    none.
 * Source   notes, "setting ray"; the printed i / (screen_width - 1) is an erratum.
 * Proof    docs/derivations/pixel_ray.md
 *
 * Law 1: mirrored columns have directions whose x differ in sign only; rows likewise in y.
 * Law 2: the middle pixel of odd sizes looks along (0,0,-1) exactly. */
SURE_TIERED(sure_ray, sure_pixel_ray, const sure_camera *camera, int width, int height, int column,
            int row);

SURE_C_END
