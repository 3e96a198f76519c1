/* SPDX-License-Identifier: MIT */
/* The cone in double-doubles. */
#pragma once

#include "../../numbers/environment.h"
#include "../capped/capped_close.h"
#include "cone_filter.h"

#include <assert.h>

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static inline filter_verdict cone_closely(const sure_ray *ray, const void *shape,
                                          const axial_terms *of, const known_discriminant *known,
                                          filter_interval *found)
{
    const sure_cone *s = shape;
    assert(environment_is_nearest() && known->value >= 0);
    vector_dd axis = vector_between_dd(NULL, s->apex, s->base);
    vector_dd m = vector_between_dd(NULL, s->apex, ray->origin);
    vector_dd d = vector_of_dd(NULL, ray->direction);
    dd height = vector_square_dd(NULL, axis);
    dd slant = dd_add(NULL, height, dd_square(NULL, dd_of(NULL, s->radius)));
    dd e = capped_tilted(vector_dot_dd(NULL, axis, d)), f = vector_dot_dd(NULL, axis, m);
    dd a = difference_dd(NULL, cone_form_dd(NULL, height, slant, vector_square_dd(NULL, d), e, e));
    dd b = difference_dd(NULL, cone_form_dd(NULL, height, slant, vector_dot_dd(NULL, m, d), f, e));
    dd root = dd_mul(NULL, height, capped_root((dd){known->value, known->rest}));
    double all = of->height * of->height * of->d_d + of->slant * (e.head * e.head);
    double reach = of->height * of->size, a_bound = DD_SHARE * SURE_CONE_LEADING_BOUND;
    bool steep = a.head < 0;
    const dd out_of_sight = {0x1p600, 0};
    capped_ends at = {.less = dd_div(NULL, dd_negate(NULL, dd_add(NULL, b, root)), a),
                      .more = dd_div(NULL, dd_sub(NULL, root, b), a),
                      .base = dd_div(NULL, dd_sub(NULL, height, f), e),
                      .top = dd_div(NULL, dd_negate(NULL, f), e)};
    if (steep && e.head > 0)
        at.more = out_of_sight;
    if (steep && e.head < 0)
        at.less = dd_negate(NULL, out_of_sight);
    axial_line line = {
        .less_at = steep ? END_MORE : END_LESS,
        .more_at = steep ? END_LESS : END_MORE,
        .e = -e.head,
        .wall_error =
            DD_SHARE * SURE_CONE_WALL_BOUND * sqrt(all * (of->slant * reach)) / fabs(a.head),
        .plane_error = DD_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = a.head * a.head > a_bound * a_bound * all * (of->slant * of->height * of->d_d),
    };
    if (known->value > 0 || !steep)
        axial_known(known, known->error, of->height * of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

#define CONE_CLOSE CAPPED_CLOSE(cone)
