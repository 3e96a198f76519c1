/* SPDX-License-Identifier: MIT */
/* Where a pixel's middle is on the viewport. */
#pragma once

#include <surehit/pixel_ray.h>

#include <stdbool.h>

/* Of a scene: do squares of ways to its pixels stay in range, with room? */
static inline bool pixel_scales_ok(const sure_camera *camera)
{
    const double most = 0x1p400;
    return camera->focal_length >= 1 / most && camera->focal_length <= most &&
           camera->viewport_width <= most && camera->viewport_height <= most;
}

/* Of pixel i of n: odd is 2 i + 1 - n, and twice 2 n, so that mirrored pixels differ in sign only.
 * Of any numbers. */
#define PIXEL_OFFSET(extent, odd, twice) ((extent) * ((odd) / (twice)))
