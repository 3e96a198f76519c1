/* SPDX-License-Identifier: MIT */
/* Cases of one object and many rays, or of one ray and many objects, of those where each has its
 * own: ray and object lie to each other as before, but for roundings. */
#pragma once

#include "../../cases/regimes.h"

/* Is the object the same, number by number? */
bool case_same_object(const sure_case *a, const sure_case *b);

/* The case's ray, in place and size, before another object. */
sure_case case_before_object(const sure_case *c, const sure_object *to);

/* The case's object, in place, direction and size, before another ray, whole from its origin on. A
 * box is brought to where its low corner comes, but not turned. */
sure_case case_before_ray(const sure_case *c, const sure_ray *to);
