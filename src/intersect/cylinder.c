#include "cylinder_height.h"
#include "cylinder_wall.h"

/* The chord of the capped cylinder: what the wall's body and the slab between the end planes have
 * in common (cylinder_wall.h, cylinder_height.h derive the two). */
#ifndef SURE_STABLE
static span cylinder_span(const sure_ray *ray, const sure_cylinder *cylinder)
{
    cylinder_line line = cylinder_line_from(ray, cylinder);
    return span_within(cylinder_wall_span(&line), cylinder_height_span(&line));
}
#else
static span cylinder_span(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sight s = cylinder_line_from(ray, cylinder);
    return sight_span(span_within(cylinder_wall_span(&s), cylinder_height_span(&s)), &s);
}
#endif

SPAN_QUESTIONS(cylinder)

sure_vec3 TIER(sure_cylinder_normal)(const sure_ray *ray, const sure_cylinder *cylinder,
                                     const sure_hit *hit)
{
    vec3 axis = scale_way(cylinder->base, cylinder->top);
    if (hit->part == SURE_PART_TOP)
        return span_normal(axis, true, ray);
    if (hit->part == SURE_PART_BASE)
        return span_normal(vec3_negate(axis), true, ray);
    vec3 outward = cylinder_wall_outward(sight_point(ray, hit->t, cylinder->base), axis);
    return span_normal(outward, cylinder->radius > 0, ray);
}
