/* SPDX-License-Identifier: MIT */
/* Where a pixel's middle is on the viewport. */
#pragma once

/* Of pixel i of n: odd is 2 i + 1 - n, and twice 2 n, so that mirrored pixels differ in sign only.
 * Of any numbers. */
#define PIXEL_OFFSET(extent, odd, twice) ((extent) * ((odd) / (twice)))
