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

/* What the row has besides slope, unit_normal, outward and bounds. */
#define CAPPED_SURFACE(solid)                                                                      \
    .plane = capped_plane, .slope = slope, .unit_normal = unit_normal,                             \
    .side_ddb = solid##_side_ddb, .side_exact = solid##_side_exact,                                \
    .has_inside = capped_has_inside, .outward = outward, .spawn_quick = solid##_spawn_quick,       \
    .bounds = bounds
