#include "cone_height.h"
#include "cone_normal.h"
#include "cone_wall.h"

/* The chord of the capped cone: what the kept nappe's body and the slab between apex and base have
 * in common (cone_wall.h, cone_height.h derive the two). */
static span cone_chord(cone_line line)
{
    return span_within(cone_height_nappe(&line), cone_height_span(&line));
}

static span cone_span(const sure_ray *ray, const sure_cone *cone)
{
    cone_line line = cone_line_from(ray, cone);
    return cone_line_span(cone_chord(line), &line);
}

SPAN_QUESTIONS(cone)

sure_vec3 TIER(sure_cone_normal)(const sure_ray *ray, const sure_cone *cone, const sure_hit *hit)
{
    vec3 axis = scale_way(cone->base, cone->apex);
    if (hit->part == SURE_PART_BASE)
        return span_normal(vec3_negate(axis), true, ray);
    vec3 from_apex = sight_point(ray, hit->t, cone->apex);
    if (vec3_is_zero(from_apex))
        return span_normal(axis, true, ray);
    real radius = scale_unit(cone->base, cone->apex) * (real)cone->radius;
    vec3 outward = cone_wall_outward(from_apex, axis, radius);
    return span_normal(outward, cone->radius > 0, ray);
}
