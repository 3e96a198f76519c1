/* SPDX-License-Identifier: MIT */
#include "cone_wall.h"

#include <surehit/cone_wall.h>

/* A point or two of the double cone, a line of it, or nothing. */
static span cone_wall_points(const quadratic *q)
{
    real roots[2];
    if (q->a == 0 && q->half_b == 0)
        return q->c == 0 ? span_line(SURE_PART_WALL, true) : span_empty();
    if (q->a == 0) {
        real t = -(q->c / q->half_b) / 2;
        return span_of(t, t, SURE_PART_WALL);
    }
    if (!quadratic_roots(q->a, q->half_b, q->c, roots))
        return span_empty();
    return span_of(roots[0], roots[1], SURE_PART_WALL);
}

sure_status TIER(sure_cone_wall_hit)(const sure_ray *ray, const sure_cone *cone, sure_hit *hit)
{
    SPAN_REALS(ray, cone);
    if (sure_cone_check(ray, cone) != SURE_FIELD_NONE)
        return SURE_INVALID;
    cone_line products = cone_line_from(line, of);
    quadratic q = cone_wall_quadratic(&products);
    span points = cone_wall_points(&q);
    return span_hit(&points, line, hit);
}
