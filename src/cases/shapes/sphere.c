/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "case_shape.h"

/* The larger of two even numbers crowds outwards, nearly as volume does. */
static sure_vec3 inner(const layout *lay, rng *g)
{
    double x = rng_between(g, 0, 1);
    double y = rng_between(g, 0, 1);
    double out = lay->r * fmax(x, y);
    return scaled(out, rng_unit(g));
}

static boundary_point boundary(const layout *lay, rng *g)
{
    sure_vec3 normal = rng_unit(g);
    return (boundary_point){scaled(lay->r, normal), normal};
}

static void tangent(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    lay->p.x = lay->r;
    lay->d.y = rng_offset(g, WAY_BITS);
    lay->d.z = lay->d.y == 0 ? rng_signed(g, WAY_BITS) : rng_offset(g, WAY_BITS);
}

static void on_side(layout *lay, rng *g)
{
    (void)g;
    lay->p.x = lay->r;
}

static void cross(crossings *all, const layout *lay)
{
    across xy = across_axis(lay);
    double o = lay->p.z, d = lay->d.z;
    cross_round(all, lay, xy.dd + d * d, xy.od + o * d, xy.oo + o * o - lay->r * lay->r);
}

static bool moved(const double *object, const movement *how, double *to)
{
    double by = how->by[0];
    to[3] = nextafter(object[3] + by, by < 0 ? -INFINITY : INFINITY);
    return true;
}

const case_shape case_sphere = {
    CASE_ON_AXIS,       .inner = inner,     .boundary = boundary,
    .tangent = tangent, .on_side = on_side, .enter_side = enter_side,
    .cross = cross,     .moved = moved,     .small_objects = 4 * SMALL_VECTORS, /* radii 0 .. 3 */
};
