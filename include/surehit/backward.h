/* SPDX-License-Identifier: MIT */
/* The backward tracer: from the eye to the light. */
#pragma once

#include <surehit/statistics.h>
#include <surehit/scene.h>

SURE_C_BEGIN

/* Step 1: the nearest object along the ray in [t_min, t_max]; `leaving` is the surface point that
 * the ray comes from, NULL for none.
 *
 * Entry    a scene whose objects are valid, a valid ray.
 * Returns  SURE_HIT and *nearest, or SURE_MISS and *nearest untouched. What is invalid is never
 *          met, and never told: sure_object_check tells it. */
sure_status sure_backward_nearest(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                  const sure_surface_point *leaving, sure_nearest *nearest);

/* The four steps for one pixel: distance, hit point, colour, light.
 *
 * Entry    a scene whose objects are valid; 0 <= column < width, 0 <= row < height, row 0 lowest.
 * Returns  the linear colour, not clamped; black where no object is met.
 * Bound    none: visibility is what the tier decides.
 * Source   notes, "Ray Tracer", steps 1 to 4.
 * Proof    docs/derivations/backward.md
 *
 * Law 1: the colour depends on nothing but scene, tier and pixel.
 * Law 2: exchanging objects that tie nowhere leaves the colour.
 * Law 3: an eye exactly on a surface sees past it. */
sure_vec3 sure_backward_pixel(const sure_scene *scene, sure_tier tier, int column, int row);

/* The same, and *statistics (or NULL) is told what happened on the way, which takes more time. */
sure_vec3 sure_backward_pixel_told(const sure_scene *scene, sure_tier tier, int column, int row,
                                   sure_statistics *statistics);

/* The colours of `count` pixels, each that of sure_backward_pixel. In tier certain eight at a time
 * are drawn together, faster the closer they lie. */
void sure_backward_pixels(const sure_scene *scene, sure_tier tier, size_t count, const int *column,
                          const int *row, sure_vec3 *color);

SURE_C_END
