/* SPDX-License-Identifier: MIT */
/* scales: short whole vectors, each times a length of its own, so that what cancels does so to the
 * last bit, far from where it would be seen. */
#include "../shapes/case_shape.h"

#include "../../numbers/places.h"

#include <math.h>

static sure_vec3 short_vector(rng *g)
{
    sure_vec3 v = {rng_integer(g, 1, 7), 0, 0};
    v.y = rng_integer(g, -7, 7);
    v.z = rng_integer(g, -7, 7);
    return v;
}

static double power_of(rng *g, int low, int high)
{
    return times_two_to(1, rng_integer(g, low, high));
}

/* The object's first point at -back along a, its second one at ahead, its normal a itself. */
static void put_object(sure_case *c, sure_vec3 a, double back, double ahead, double radius)
{
    const int count = case_numbers(c->object.shape);
    for (int i = AT_OBJECT; i < count;) {
        const sure_kind kind = field_at(c->object.shape, i)->kind;
        if (kind == SURE_KIND_RADIUS) {
            *case_number(c, i++) = radius;
            continue;
        }
        const double by = kind == SURE_KIND_POINT ? -back : ahead;
        *case_vector(c, i) = scaled(by, a);
        i += 3;
    }
    object_mend(c->object.shape, case_number(c, AT_OBJECT));
}

/* Across a, in any direction, or almost along a. */
static sure_vec3 direction_beside(sure_vec3 a, rng *g)
{
    sure_vec3 b = short_vector(g);
    while (largest(cross_of(a, b)) == 0)
        b = short_vector(g);
    switch (rng_integer(g, 0, 2)) {
    case 0: return sum_of(b, power_of(g, 0, 40), a);
    case 1: return b;
    default: return cross_of(a, b);
    }
}

/* The line passes the origin, as the axis does, or a point a short vector beside it. */
sure_case make_scales(sure_shape shape, rng *g)
{
    sure_case c = {.ray = {.t_max = HUGE_VAL}, .object.shape = shape};
    const sure_vec3 a = short_vector(g);
    const double size = power_of(g, -60, 0);
    double way = rng_whole(g, 44), back = size, radius = rng_whole(g, 30);
    radius *= power_of(g, -80, 0);
    if (rng_chance(g, 1, 4)) { /* the object is far from its first point, not the ray */
        back = way;
        way = size;
    }
    put_object(&c, a, back, size, radius);
    c.ray.direction = direction_beside(a, g);
    c.ray.origin = scaled(-way, c.ray.direction);
    if (rng_chance(g, 1, 2)) {
        const double off = power_of(g, -80, 0);
        c.ray.origin = sum_of(c.ray.origin, off, short_vector(g));
    }
    if (rng_chance(g, 1, 4))
        c.ray.t_max = way;
    if (rng_chance(g, 1, 4))
        nudge(&c, g);
    return c;
}
