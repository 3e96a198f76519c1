/* SPDX-License-Identifier: MIT */
#include "../../numbers/valid.h"
#include "cone_wall.h"

#include <surehit/cone_normal.h>

#include <assert.h>

sure_vec3 TIER(sure_cone_wall_normal)(sure_vec3 point, const sure_cone *cone)
{
    assert(all_finite(point) && all_finite(cone->base) && all_finite(cone->apex));
    assert(radius_ok(cone->radius) && !same_point(cone->base, cone->apex));
    vec3 axis = vec3_between(cone->base, cone->apex);
    vec3 from_apex = vec3_between(cone->apex, point);
    vec3 outward =
        vec3_is_zero(from_apex) ? axis : cone_wall_outward(from_apex, axis, (real)cone->radius);
    return vec3_public(vec3_is_direction(outward) ? vec3_unit(outward) : (vec3){0, 0, 0});
}
