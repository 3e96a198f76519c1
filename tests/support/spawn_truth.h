/* SPDX-License-Identifier: MIT */
/* What is provable of a spawned origin, by the reference. */
#pragma once

#include <stdbool.h>

#include <surehit/spawn.h>

/* Strictly on that side? Entry: of object_sided, a finite point. */
bool spawn_is_on_side(const sure_object *sided, sure_vec3 point, sure_side side);

/* Is any point of the box of SURE_SPAWN_STEPS around p on that side? */
bool spawn_box_has(const sure_object *sided, const double p[3], sure_side side);

/* Can there be no origin next to p at all? A flat surface has both sides everywhere, any surface an
 * outside; but not where one step in some coordinate leads beyond the greatest double. */
bool spawn_may_have_none(const sure_object *object, const double p[3], sure_side side);
