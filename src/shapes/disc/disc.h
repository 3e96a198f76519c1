/* SPDX-License-Identifier: MIT */
/* The disc stem's formula, for the tiers that take it. */
#pragma once

#include "../../geometry/quadratic.h"
#include "../plane/plane.h"

/* The plane of the disc, then the distance from its centre Q, rc = Q - o:
 *
 *     t = N.rc / N.d,  |t d - rc|^2 <= r^2
 *
 * A line in the plane cuts the chord |t d - rc|^2 <= r^2 from the disc:
 *
 *     d.d t^2 - 2 rc.d t + rc.rc - r^2 <= 0
 */
static inline bool disc_holds(const plane_line *line, real t, real r)
{
    vec3 from_centre = vec3_sub(vec3_scale(t, line->d), line->rc);
    return vec3_dot(from_centre, from_centre) <= r * r;
}

static inline span disc_line_span(const plane_line *line, real r)
{
    vec3 d = line->d, rc = line->rc;
    span found = plane_line_span(line);
    if (found.boundary) {
        real roots[2];
        if (!quadratic_roots(vec3_dot(d, d), -vec3_dot(rc, d), vec3_dot(rc, rc) - r * r, roots))
            return span_empty();
        found.enter = roots[0];
        found.leave = roots[1];
        found.endless = false;
        return found;
    }
    return disc_holds(line, found.enter, r) ? found : span_empty();
}
