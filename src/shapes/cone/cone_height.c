/* SPDX-License-Identifier: MIT */
#include "../../numbers/valid.h"
#include "cone_height.h"
#include "../capped/end_points.h"

#include <surehit/cone_height.h>

#include <assert.h>

sure_field TIER(sure_cone_from_axis)(sure_vec3 centre, sure_vec3 axis, double radius, double height,
                                     sure_cone *cone)
{
    sure_vec3 base, apex;
    real r = (real)radius;
    sure_field bad = end_points(vec3_from(centre), vec3_from(axis), r, (real)height,
                                SURE_FIELD_APEX, &base, &apex);
    if (bad == SURE_FIELD_NONE)
        *cone = (sure_cone){base, apex, r};
    return bad;
}

/* |PQ|^2 <= r^2 + h^2 and N.(Q - P) >= 0 */
int TIER(sure_cone_height)(sure_vec3 point, const sure_cone *cone)
{
    assert(all_finite(point) && all_finite(cone->base) && all_finite(cone->apex));
    assert(radius_ok(cone->radius) && !same_point(cone->base, cone->apex));
    vec3 apex = vec3_from(cone->apex);
    vec3 n = vec3_sub(apex, vec3_from(cone->base));
    vec3 pq = vec3_sub(apex, vec3_from(point));
    real r = (real)cone->radius;
    return vec3_dot(pq, pq) <= r * r + vec3_dot(n, n) && vec3_dot(n, pq) >= 0;
}
