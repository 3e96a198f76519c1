/* SPDX-License-Identifier: MIT */
#include "../../numbers/valid.h"
#include "cylinder_height.h"
#include "../capped/end_points.h"

#include <surehit/cylinder_height.h>

#include <assert.h>

sure_field TIER(sure_cylinder_from_axis)(sure_vec3 centre, sure_vec3 axis, double radius,
                                         double height, sure_cylinder *cylinder)
{
    sure_vec3 base, top;
    real r = (real)radius;
    sure_field bad = end_points(vec3_from(centre), vec3_from(axis), r, (real)height, SURE_FIELD_TOP,
                                &base, &top);
    if (bad == SURE_FIELD_NONE)
        *cylinder = (sure_cylinder){base, top, r};
    return bad;
}

/* N.(P - top) <= 0 and N.(P - base) >= 0 */
int TIER(sure_cylinder_height)(sure_vec3 point, const sure_cylinder *cylinder)
{
    assert(all_finite(point) && all_finite(cylinder->base) && all_finite(cylinder->top));
    assert(radius_ok(cylinder->radius) && !same_point(cylinder->base, cylinder->top));
    vec3 p = vec3_from(point), base = vec3_from(cylinder->base), top = vec3_from(cylinder->top);
    vec3 n = vec3_sub(top, base);
    return vec3_dot(n, vec3_sub(p, top)) <= 0 && vec3_dot(n, vec3_sub(p, base)) >= 0;
}
