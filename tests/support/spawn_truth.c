/* SPDX-License-Identifier: MIT */
#include "spawn_truth.h"

#include "../../reference/reference.h"
#include "case.h"

#include <math.h>

#include <surehit/bounds.h>

bool spawn_is_on_side(const sure_object *sided, sure_vec3 point, sure_side side)
{
    return reference_where(sided, point) == (side == SURE_SIDE_INSIDE ? -1 : 1);
}

bool spawn_box_has(const sure_object *sided, const double p[3], sure_side side)
{
    const int most = SURE_SPAWN_STEPS, edge = 2 * most + 1;
    for (int i = 0; i < edge * edge * edge; i++) {
        sure_vec3 q = {step_ulps(p[0], i % edge - most), step_ulps(p[1], i / edge % edge - most),
                       step_ulps(p[2], i / edge / edge - most)};
        if (isfinite(q.x) && isfinite(q.y) && isfinite(q.z) && spawn_is_on_side(sided, q, side))
            return true;
    }
    return false;
}

static bool at_the_end(const double p[3])
{
    for (int i = 0; i < 3; i++) {
        if (isinf(p[i]) || isinf(step_ulps(fabs(p[i]), 1)))
            return true;
    }
    return false;
}

bool spawn_may_have_none(const sure_object *object, const double p[3], sure_side side)
{
    return (side == SURE_SIDE_INSIDE && sure_shape_info_of(object->shape)->solid) || at_the_end(p);
}
