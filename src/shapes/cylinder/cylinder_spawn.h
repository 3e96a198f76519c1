/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on a cylinder's wall. */
#pragma once

#include "../capped/capped_spawn.h"
#include "cylinder_filter.h"

/* 2 F = |A x p|^2 - r^2 H, p seen from the base */
static inline surface cylinder_surface(const line_point *line, const sure_cylinder *s)
{
    axial_point at = axial_point_at(&s->base, &s->top, seen_from(&s->base, line));
    axial_radius radius = axial_radius_of(&at);
    dd height = axial_square(at.a);
    two_terms_dd body = cylinder_body_dd(NULL, radius.square, height, dd_of(NULL, s->radius));
    double f = remainder_of(body.more, dd_negate(NULL, body.less));
    double a = at.a_most, depth = dot(axial_axis(&at), heads_of(&at.p));
    surface wall =
        wall_surface(&at, 0.5 * f, radius.most + s->radius * a, a * a, height.head, depth);
    wall.n = radial_of(&at);
    wall.beyond = axial_beyond(&at, s->radius);
    return wall;
}

CAPPED_SPAWN(cylinder, true)
