/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "case_shape.h"

/* In a quarter of draws off the disc. */
static void enter(layout *lay, rng *g)
{
    double x = floor(rng_between(g, 0, lay->r));
    if (rng_chance(g, 1, 4))
        x += lay->r;
    enter_flat(lay, false, x, g);
}

/* The rim goes as far again as roundings may lead the centre aside. */
static bool moved(const double *object, const movement *how, double *to)
{
    moved_axis axis;
    double by = how->by[0];
    if (!moved_flat(object, how, to) || !moved_axis_of(object, 7, object + 3, how->along, &axis))
        return false;
    to[6] = object[6] + moved_farther(by, 4 * axis.rounding);
    return true;
}

/* A cylinder, whose axis may be tilted and has next to no height. With E half of that, u a
 * rounding and R the radius, E must be more than by + 2 u + u R / E: the root of u R is enough. */
static bool slab(const double *object, double by, sure_object *slab)
{
    const double known[4] = {object[0], object[1], object[2], object[6]};
    double ends[7];
    moved_axis axis;
    if (!moved_axis_of(known, 4, object + 3, 2 * by, &axis))
        return false;
    double radius = object[6] + by + 4 * axis.rounding;
    double tilt = axis.aligned ? 0 : 2 * sqrt(2 * axis.rounding) * sqrt(radius);
    double half = by + 4 * axis.rounding + tilt;
    moved_point(object, -half, axis.unit, ends);
    moved_point(object, half, axis.unit, ends + 3);
    ends[6] = radius;
    slab->shape = SURE_SHAPE_CYLINDER;
    memcpy(&slab->as, ends, sizeof ends);
    return true;
}

const case_shape case_disc = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM,
    .inner = random_in_base,
    .boundary = random_cap_point,
    .tangent = tangent_at_rim,
    .on_cap = on_cap,
    .enter_cap = enter,
    .cross = cross_base,
    .moved = moved,
    .slab = slab,
    .small_objects = 4 * SMALL_VECTORS * (SMALL_VECTORS - 1), /* radii 0 .. 3 */
};
