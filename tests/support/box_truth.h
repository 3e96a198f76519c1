/* SPDX-License-Identifier: MIT */
/* Boxes by exact arithmetic: what an object needs, and which rays meet one. */
#pragma once

#include <stdbool.h>

#include <surehit/bvh.h>
#include <surehit/ray.h>

/* The sign of how much farther out the face at `face` is than the closed object reaches along
 * coordinate `axis`, upwards or downwards: -1 where it cuts some of it off. Entry: valid, no
 * plane; the environment is the default one. */
int box_truth_room(const sure_object *object, int axis, bool upwards, double face);

/* Has the ray a point with t in [t_min, t_max] in the closed box? Likewise. */
bool box_truth_meets(const sure_bounds *box, const sure_ray *ray);
