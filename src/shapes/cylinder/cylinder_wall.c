/* SPDX-License-Identifier: MIT */
#include "../../numbers/valid.h"
#include "cylinder_wall.h"

#include <surehit/cylinder_wall.h>

#include <assert.h>

sure_status TIER(sure_cylinder_wall_hit)(const sure_ray *ray, const sure_cylinder *cylinder,
                                         sure_hit *hit)
{
    SPAN_REALS(ray, cylinder);
    if (sure_cylinder_check(ray, cylinder) != SURE_FIELD_NONE)
        return SURE_INVALID;
    cylinder_line products = cylinder_line_from(line, of);
    span chord = cylinder_wall_span(&products);
    return span_hit(&chord, line, hit);
}

sure_vec3 TIER(sure_cylinder_wall_normal)(sure_vec3 point, const sure_cylinder *cylinder)
{
    assert(all_finite(point) && all_finite(cylinder->base) && all_finite(cylinder->top));
    assert(radius_ok(cylinder->radius) && !same_point(cylinder->base, cylinder->top));
    vec3 axis = vec3_between(cylinder->base, cylinder->top);
    vec3 outward = cylinder_wall_outward(vec3_between(cylinder->base, point), axis);
    return vec3_public(vec3_is_direction(outward) ? vec3_unit(outward) : (vec3){0, 0, 0});
}
