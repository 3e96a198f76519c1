/* SPDX-License-Identifier: MIT */
/* From file to picture: objects and lights stay where the file has them, and the camera stands
 * among them. End points of bodies are made from centre, axis and height. */
#pragma once

#include "rt.h"

/* Makes *scene (free it with placement_free) from *file, whose materials are the scene's then. On
 * false an error line was written to `messages` (end points that collapse by rounding) and nothing
 * is left allocated but the file. */
bool placement(rt_scene *file, FILE *messages, sure_scene *scene);

void placement_free(sure_scene *scene);

/* For scene->floats, where the tier takes them (free it). NULL, without memory, draws the same. */
sure_float_object *placement_floats(const sure_scene *scene, sure_tier tier);

/* 2 focal tan(pi/360 fov), 0 < fov < 180, focal a power of two: correctly rounded
 * unless the tangent is subnormal, so that pictures do not depend on the C library. */
double viewport_extent(double focal, double fov);
