/* SPDX-License-Identifier: MIT */
#include "cone_height.h"
#include "cone_wall.h"

/* The chord of the capped cone: what the kept nappe's body and the slab between apex and base have
 * in common (cone_wall.h, cone_height.h derive the two). */
static inline span cone_span(const real_ray *ray, const real *of)
{
    cone_line line = cone_line_from(ray, of);
    return span_within(cone_height_nappe(&line), cone_height_span(&line));
}

/* Where a < 0 the line is inside beyond the roots, which then descend; it is kept to the end to
 * which it falls (cone_height.h). */
static inline bool cone_plain(const real_ray *ray, const real *of, span_first *first)
{
    static const real endless[2] = {-(real)INFINITY, (real)INFINITY};
    cone_line line = cone_line_from(ray, of);
    quadratic q = cone_wall_quadratic(&line);
    real quarter = quadratic_quarter(&q), wall[2], heights[2];
    if (!(surely_not_zero(q.a) && surely_not_zero(line.n_d) &&
          round_surely_valid(ray, quarter, line.r) && ((q.a > 0) | (quarter >= 0))))
        return false;
    quadratic_ends(&q, quarter, wall);
    cone_height_ends(&line, heights);
    bool falling = line.n_d < 0, both_nappes = q.a < 0;
    real kept_enter = span_earlier(wall[0], endless[!(both_nappes & !falling)]);
    real kept_leave = span_later(wall[1], endless[both_nappes & falling]);
    real enter = span_later(kept_enter, heights[falling]);
    real leave = span_earlier(kept_leave, heights[!falling]);
    real t = span_first_end(enter, leave, ray);
    *first = (span_first){.met = (quarter >= 0) & (enter <= leave),
                          .t = t,
                          .part = span_either(t == heights[0], SURE_PART_BASE, SURE_PART_WALL),
                          .leaves = enter < ray->t_min};
    return true;
}

SPAN_QUESTIONS(cone)

sure_vec3 TIER(sure_cone_normal)(const sure_ray *ray, const sure_cone *cone, const sure_hit *hit)
{
    vec3 axis = vec3_between(cone->base, cone->apex);
    if (hit->part == SURE_PART_BASE)
        return span_normal(vec3_negate(axis), true, ray);
    vec3 from_apex = span_point(ray, hit->t, cone->apex);
    if (vec3_is_zero(from_apex))
        return span_normal(axis, true, ray);
    vec3 outward = cone_wall_outward(from_apex, axis, (real)cone->radius);
    return span_normal(outward, cone->radius > 0, ray);
}
