/* SPDX-License-Identifier: MIT */
/* What cylinder and cone share of their surface. Both structs are the base's centre, the axis's
 * other end and the radius. */
#pragma once

#include "../../stages/hits/normal.h"
#include "../bounds.h"
#include "capped_spawn.h"

static inline bool capped_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_vec3 *ends = shape;
    bool top = part == SURE_PART_TOP;
    *plane = (part_plane){ends[!top], ends[top], ends[top]};
    return part != SURE_PART_WALL;
}

static inline bool capped_has_inside(const void *shape)
{
    const double *radius = (const double *)shape + 6;
    return !is_zero_bits(*radius);
}

/* What the row has; `solid`_slope, _unit_normal, _outward and _bounds are the solid's own. */
#define CAPPED_SURFACE(solid)                                                                      \
    .plane = capped_plane, .slope = solid##_slope, SURFACE_SLOPES(solid),                          \
    .unit_normal = solid##_unit_normal, SURFACE_SIDES(solid), .has_inside = capped_has_inside,     \
    .outward = solid##_outward, .bounds = solid##_bounds
