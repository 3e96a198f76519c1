/* SPDX-License-Identifier: MIT */
/* The first stage of sure_spawn on a cone's wall. */
#pragma once

#include "../capped/capped_spawn.h"
#include "cone_filter.h"

/* 2 F = H |A x p|^2 - r^2 (A.p)^2, p seen from the apex */
static inline surface cone_surface(const line_point *line, const sure_cone *s)
{
    axial_point at = axial_point_at(&s->apex, &s->base, seen_from(&s->apex, line));
    axial_radius radius = axial_radius_of(&at);
    dd height = axial_square(at.a), along = axial_along(&at);
    two_terms_dd body =
        cone_body_dd(NULL, height, dd_of(NULL, s->radius), radius.square, dd_square(NULL, along));
    double f = remainder_of(body.more, dd_negate(NULL, body.less)), rr = s->radius * s->radius;
    double a = at.a_most, h = height.head, depth = dd_value(along), inward = rr * depth;
    double size = cone_measure(&at, &radius, h, rr, depth);
    surface wall = wall_surface(&at, 0.5 * f, size, (h + rr) * (a * a), h, depth);
    sure_vec3 out = radial_of(&at), axis = axial_axis(&at);
    wall.n = (sure_vec3){h * out.x - inward * axis.x, h * out.y - inward * axis.y,
                         h * out.z - inward * axis.z};
    wall.beyond = axial_beyond(&at, s->radius);
    return wall;
}

CAPPED_SPAWN(cone, false)
