/* SPDX-License-Identifier: MIT */
#include "cylinder_height.h"
#include "cylinder_wall.h"

/* The chord of the capped cylinder: what the wall's body and the slab between the end planes have
 * in common (cylinder_wall.h, cylinder_height.h derive the two). */
static inline span cylinder_span(const real_ray *ray, const real *of)
{
    cylinder_line line = cylinder_line_from(ray, of);
    return span_within(cylinder_wall_span(&line), cylinder_height_span(&line));
}

/* A common end of wall and slab (a rim) is the cap's; one of both end planes, the base's. */
static inline sure_part cylinder_part_at(real t, const real heights[2])
{
    sure_part top_or_wall = span_either(t == heights[1], SURE_PART_TOP, SURE_PART_WALL);
    return span_either(t == heights[0], SURE_PART_BASE, top_or_wall);
}

static INLINED bool cylinder_plain(const real_ray *ray, const real *of, span_first *first)
{
    cylinder_line line = cylinder_line_from(ray, of);
    quadratic q = cylinder_wall_quadratic(&line);
    real quarter = quadratic_quarter(&q), wall[2], heights[2];
    if (!(q.a > 0 && surely_not_zero(line.n_d) && round_surely_valid(ray, quarter, line.r)))
        return false;
    quadratic_ends(&q, quarter, wall);
    cylinder_height_ends(&line, heights);
    bool falling = line.n_d < 0;
    real enter = span_later(wall[0], heights[falling]);
    real leave = span_earlier(wall[1], heights[!falling]);
    real t = span_first_end(enter, leave, ray);
    *first = (span_first){.met = (quarter >= 0) & (enter <= leave),
                          .t = t,
                          .part = cylinder_part_at(t, heights),
                          .leaves = enter < ray->t_min};
    return true;
}

SPAN_QUESTIONS(cylinder)

sure_vec3 TIER(sure_cylinder_normal)(const sure_ray *ray, const sure_cylinder *cylinder,
                                     const sure_hit *hit)
{
    vec3 axis = vec3_between(cylinder->base, cylinder->top);
    if (hit->part == SURE_PART_TOP)
        return span_normal(axis, true, ray);
    if (hit->part == SURE_PART_BASE)
        return span_normal(vec3_negate(axis), true, ray);
    vec3 outward = cylinder_wall_outward(span_point(ray, hit->t, cylinder->base), axis);
    return span_normal(outward, cylinder->radius > 0, ray);
}
