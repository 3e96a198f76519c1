/* SPDX-License-Identifier: MIT */
/* The cylinder in double-doubles. */
#pragma once

#include "../../numbers/environment.h"
#include "../capped/capped_close.h"
#include "cylinder_filter.h"

#include <assert.h>

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static inline filter_verdict cylinder_closely(const sure_ray *ray, const void *shape,
                                              const axial_terms *of,
                                              const known_discriminant *known,
                                              filter_interval *found)
{
    const sure_cylinder *s = shape;
    assert(environment_is_nearest() && known->value >= 0);
    vector_dd axis = vector_between_dd(NULL, s->base, s->top);
    vector_dd m = vector_between_dd(NULL, s->base, ray->origin);
    vector_dd d = vector_of_dd(NULL, ray->direction);
    dd height = vector_square_dd(NULL, axis);
    dd a = vector_square_dd(NULL, vector_cross_dd(NULL, axis, d));
    dd e = capped_tilted(vector_dot_dd(NULL, axis, d)), f = vector_dot_dd(NULL, axis, m);
    dd b = cylinder_form_dd(NULL, height, vector_dot_dd(NULL, m, d), f, e);
    dd root = capped_root(dd_mul(NULL, height, (dd){known->value, known->rest}));
    double reach = of->height * of->size;
    capped_ends at = {.less = dd_div(NULL, dd_negate(NULL, dd_add(NULL, b, root)), a),
                      .more = dd_div(NULL, dd_sub(NULL, root, b), a),
                      .base = dd_div(NULL, dd_negate(NULL, f), e),
                      .top = dd_div(NULL, dd_sub(NULL, height, f), e)};
    axial_line line = {
        .less_at = END_LESS,
        .more_at = END_MORE,
        .e = e.head,
        .wall_error =
            DD_SHARE * SURE_CYLINDER_WALL_BOUND * sqrt(of->height * of->d_d * reach) / fabs(a.head),
        .plane_error = DD_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = true,
    };
    axial_known(known, known->error, of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

#define CYLINDER_CLOSE CAPPED_CLOSE(cylinder)
