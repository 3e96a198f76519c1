/* SPDX-License-Identifier: MIT */
/* What the header promises of turns about the axes: the law that is broken, or NULL. */
#pragma once

#include <surehit/rotation.h>
#include <surehit/tier.h>

typedef sure_vec3 turn(double, sure_vec3);

/* About x, y or z. */
turn *turn_of(int axis, sure_tier tier);

/* Of any angle and vector. */
const char *turn_law_broken(sure_tier tier, double angle, sure_vec3 v);
