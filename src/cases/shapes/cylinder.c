/* SPDX-License-Identifier: MIT */
#include "case_shape.h"

#include <surehit/cylinder_wall.h>

#include <math.h>

static void tangent(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    lay->h = random_whole_size(g);
    lay->p.x = lay->r;
    lay->p.z = random_side_height(lay->h, g);
    lay->d.y = rng_signed(g, WAY_BITS);
    lay->d.z = rng_offset(g, WAY_BITS);
}

static void on_side(layout *lay, rng *g)
{
    lay->p.x = lay->r;
    lay->p.z = random_within(lay->h, g);
}

static void cross(crossings *all, const layout *lay)
{
    across xy = across_axis(lay);
    cross_flat(all, lay, 0);
    cross_flat(all, lay, lay->h);
    cross_round(all, lay, xy.dd, xy.od, xy.oo - lay->r * lay->r);
}

static bool moved(const double *object, const movement *how, double *to)
{
    const double axis_way[3] = {object[3] - object[0], object[4] - object[1],
                                object[5] - object[2]};
    double base = how->by[0], top = how->by[1], wall = how->by[2];
    moved_axis axis;
    if (!moved_axis_of(object, 7, axis_way, fmax(fmax(fabs(base), fabs(top)), fabs(wall)), &axis))
        return false;
    double height = axis.height + base + top;
    double more = moved_allowance(&axis, height, object[6] + fabs(wall));
    if (more < 0)
        return false;
    moved_point(object, -moved_farther(base, more), axis.unit, to);
    moved_point(object + 3, moved_farther(top, more), axis.unit, to + 3);
    to[6] = object[6] + moved_farther(wall, more);
    return height > 4 * more;
}

CASE_WALL(cylinder)

/* The axis stays, or far away it would be another one. */
static bool moved_wall(const sure_object *object, const movement *how, sure_object *to)
{
    double wall = how->by[2], radius = object->as.cylinder.radius + wall;
    *to = *object;
    to->as.cylinder.radius = nextafter(radius, wall > 0 ? INFINITY : -INFINITY);
    return wall != 0 && to->as.cylinder.radius >= 0 && isfinite(to->as.cylinder.radius);
}

const case_shape case_cylinder = {
    CASE_CAPPED,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM | CASE_HAS_AXIS | CASE_HAS_HEIGHT | CASE_HAS_TWO_CAPS,
    .tangent = tangent,
    .on_side = on_side,
    .enter_side = enter_side,
    .cross = cross,
    .moved = moved,
    .wall_hit = wall_hit,
    .wall_side = wall_side,
    .wall_moved = moved_wall,
};
