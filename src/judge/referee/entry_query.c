/* SPDX-License-Identifier: MIT */
#include "entry.h"

#include "../../numbers/sums.h"

#include <math.h>

entry entry_for(const entry *all, query asks)
{
    entry of = *all;
    if (asks == QUERY_INSIDE)
        of.from_zero = of.ray = of.segment = of.line = of.outside = false;
    if (asks == QUERY_INSIDE || asks == QUERY_INTERVAL)
        of.misses[EVENT_INSIDE] = of.zero_inside = false;
    return of;
}

static sure_ray ray_of_point(sure_vec3 at)
{
    return (sure_ray){at, {1, 0, 0}, 0, 0};
}

static void ask_point(sure_case *c)
{
    sure_hit hit;
    if (sure_object_hit(&c->ray, &c->object, SURE_TIER_EXACT, &hit) == SURE_HIT) {
        sure_vec3 at = add(c->ray.origin, scaled(hit.t, c->ray.direction));
        if (isfinite(at.x) && isfinite(at.y) && isfinite(at.z))
            c->ray.origin = at;
    }
    c->ray = ray_of_point(c->ray.origin);
}

bool entry_is_query(query asks, const sure_case *question)
{
    const sure_ray is = question->ray, wanted = ray_of_point(is.origin);
    return asks != QUERY_INSIDE ||
           (is.direction.x == wanted.direction.x && is.direction.y == wanted.direction.y &&
            is.direction.z == wanted.direction.z && is.t_min == wanted.t_min &&
            is.t_max == wanted.t_max);
}

bool entry_query(const entry *all, query asks, const sure_case *question, precision in,
                 sure_case *received)
{
    if (!entry_case(all, question, in, received))
        return false;
    if (received->wall && (asks == QUERY_INSIDE || asks == QUERY_INTERVAL))
        return false; /* it has neither chord nor interior */
    if (asks != QUERY_INSIDE)
        return true;
    sure_case point = *received;
    ask_point(&point);
    *received = point;
    return (in == PRECISION_DOUBLE || float_case(&point, received)) &&
           (!all->declared || entry_holds(all, received, in));
}
