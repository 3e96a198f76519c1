/* SPDX-License-Identifier: MIT */
/* Points of which it is hard to tell whether they are within the height of a cylinder or cone. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include <surehit/object.h>

/* Of a cylinder or cone: does it end in an apex? */
static inline bool is_pointed(const sure_object *solid)
{
    return sure_shape_info_of(solid->shape)->fields[1].name == SURE_FIELD_APEX;
}

/* By the draw: the doubles nearest to the rim of the base or top, to a point of the end's plane
 * within or outside of it, or to one on the way between the ends; some of them moved by some
 * doubles. Finite. Entry: a valid cylinder or cone. */
sure_vec3 hard_point(const sure_object *solid, uint64_t draw);

bool same_place(sure_vec3 a, sure_vec3 b);
