/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on planar parts. */
#pragma once

#include "../../stages/hits/spawn_quick.h"
#include "../capped/axial_polish.h"

/* F = p_i, of a plane across a coordinate axis. */
static inline surface level_surface(const line_point *line, level plane)
{
    dd at = plane.axis == 0 ? line->x : plane.axis == 1 ? line->y : line->z;
    dd p = seen_coordinate(at, plane.at);
    double most = fabs(p.head) + line->most;
    return (surface){.f = p.head + p.tail,
                     .f_error = SURE_CROSSING_RESIDUAL_BOUND * most,
                     .n = {plane.axis == 0, plane.axis == 1, plane.axis == 2},
                     .beyond = beyond(most),
                     .level = plane};
}

/* F = N.p */
static inline surface flat_surface(const line_point *line, const sure_vec3 *place,
                                   const sure_vec3 *normal)
{
    level plane = level_of(!is_zero_bits(normal->x), !is_zero_bits(normal->y),
                           !is_zero_bits(normal->z), *normal, place);
    if (plane.axis >= 0)
        return level_surface(line, plane);
    polish_point p = seen_from(place, line);
    double size = measure_of(*normal);
    dd xy = dd_add_loosely(dd_mul(NULL, dd_of(NULL, normal->x), p.x),
                           dd_mul(NULL, dd_of(NULL, normal->y), p.y));
    return (surface){.f = remainder_of(xy, dd_mul(NULL, dd_of(NULL, normal->z), p.z)),
                     .f_error = SURE_CROSSING_RESIDUAL_BOUND * size * p.most,
                     .n = *normal,
                     .beyond = beyond(size) | beyond(p.most),
                     .level = plane};
}

/* Both structs begin with a point and the normal. */
static inline surface planar_surface(const line_point *line, const sure_vec3 *s)
{
    return flat_surface(line, &s[0], &s[1]);
}

SPAWN_QUICK(planar_spawn_quick, planar_surface(&line, shape))
