/* SPDX-License-Identifier: MIT */
/* A light counts only if it is reached. */
#pragma once

#include <surehit/scene.h>

SURE_C_BEGIN

/* Does the straight way from the surface point to the light meet no object? The surface that the
 * way leaves cannot meet it again on the outside (it is convex); on the inside of a solid it does
 * where the solid's chord ends before the light. No epsilon.
 *
 * Entry    valid objects; a surface point of the scene; the light on the side of its normal.
 * Returns  1 when the light is reached, 0 otherwise; 1, too, where the way there is zero or
 *          overflows.
 * Bound    none: the tier's decisions on rays from a rounded point.
 * Source   notes, "apply light".
 * Proof    docs/derivations/shadow.md
 *
 * Law 1: adding an object never turns shadow into light.
 * Law 2: a lone convex object never shades a light outside its tangent plane. */
int sure_shadow_reaches(const sure_scene *scene, sure_tier tier, const sure_surface_point *from,
                        sure_vec3 light_position);

SURE_C_END
