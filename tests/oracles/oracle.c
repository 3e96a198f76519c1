/* SPDX-License-Identifier: MIT */
#include "oracle.h"

#ifdef WITH_REFERENCE
#include "reference.h"
#endif

static int bisection_compared(const sure_case *c, double x)
{
    return bisection_compare(&c->ray, &c->object, x);
}

#ifdef WITH_REFERENCE
/* What the reference leaves untouched stays 0, as in the bisection oracle's results. */
static bisection_result reference_of(const sure_case *c)
{
    bisection_result result = {.field = reference_check(&c->ray, &c->object)};
    result.status = reference_hit(&c->ray, &c->object, &result.t, &result.part, &result.normal);
    result.interval_status = reference_interval(&c->ray, &c->object, &result.interval);
    return result;
}

static int reference_compared(const sure_case *c, double x)
{
    int sign = REFERENCE_NONE;
    reference_compare_hit(&c->ray, &c->object, x, &sign);
    return sign;
}

static int reference_ordered(const sure_ray *ray, const sure_object *first,
                             const sure_object *second)
{
    int order = REFERENCE_NONE;
    reference_hit_order(ray, first, second, &order);
    return order;
}
#endif

const oracle oracles[ORACLES] = {
    {"bisection", bisection_of, bisection_compared, bisection_order},
#ifdef WITH_REFERENCE
    {"reference", reference_of, reference_compared, reference_ordered},
#endif
};
