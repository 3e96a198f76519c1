/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "../numbers/vec3.h"
#include "pixel_ray.h"

#include <surehit/pixel_ray.h>

#include <assert.h>
#include <stdint.h>

/* P_pixel = low_left + width u + height v with u, v in 0..1 across the viewport, whose middle lies
 * at focal_length in front of the eye. Pixel i of n has its centre at u = (i + 1/2) / n, so
 *
 *     x = extent (u - 1/2) = extent (2 i + 1 - n) / (2 n) */
static real offset(double extent, int pixel, int pixels)
{
    int64_t odd = 2 * (int64_t)pixel + 1 - pixels, twice = 2 * (int64_t)pixels;
    return PIXEL_OFFSET((real)extent, (real)odd, (real)twice);
}

sure_ray TIER(sure_pixel_ray)(const sure_camera *camera, int width, int height, int column, int row)
{
    assert(0 <= column && column < width && 0 <= row && row < height);
    assert(camera->focal_length > 0 && is_finite_bits(camera->focal_length));
    assert(camera->viewport_width > 0 && is_finite_bits(camera->viewport_width));
    assert(camera->viewport_height > 0 && is_finite_bits(camera->viewport_height));
    vec3 origin = vec3_from(camera->position);
    vec3 direction = {offset(camera->viewport_width, column, width),
                      offset(camera->viewport_height, row, height), -(real)camera->focal_length};
    return (sure_ray){vec3_public(origin), vec3_public(direction), 0, INFINITY};
}
