/* SPDX-License-Identifier: MIT */
#include "case_shape.h"

#include <surehit/cone_wall.h>

#include <math.h>

/* A cone of r = parts * r_step and h = parts * h_step: at height j * h_step the wall is at (parts -
 * j) * r_step, a whole number. */
typedef struct {
    double parts, r_step, h_step;
} steps;

static steps random_steps(layout *lay, rng *g)
{
    steps s;
    s.parts = rng_whole(g, PART_BITS);
    s.r_step = rng_whole(g, STEP_BITS);
    s.h_step = rng_whole(g, STEP_BITS);
    lay->r = s.parts * s.r_step;
    lay->h = s.parts * s.h_step;
    return s;
}

static sure_vec3 on_generator(const steps *s, double j)
{
    return (sure_vec3){(s->parts - j) * s->r_step, 0, j * s->h_step};
}

/* In the plane that touches the cone along the generator in the xz plane: part of the direction
 * along the generator, part across. */
static void tangent(layout *lay, rng *g)
{
    steps s = random_steps(lay, g);
    lay->p = on_generator(&s, random_side_height(s.parts, g));
    double upwards = rng_offset(g, WAY_BITS - STEP_BITS);
    lay->d.x = -upwards * s.r_step;
    lay->d.y = rng_signed(g, WAY_BITS);
    lay->d.z = upwards * s.h_step;
}

static void on_side(layout *lay, rng *g)
{
    steps s = random_steps(lay, g);
    lay->p = on_generator(&s, random_within(s.parts, g));
}

static void enter_wall(layout *lay, rng *g)
{
    double parts = rng_integer(g, 1, 8), part = rng_integer(g, 0, 8);
    double r_step = rng_whole(g, 10), h_step = random_step_height(g);
    lay->r = parts * r_step;
    lay->h = parts * h_step;
    part = part > parts ? parts : part;
    lay->p = (sure_vec3){(parts - part) * r_step, 0, part * h_step};
    lay->d = random_entering(g, (sure_vec3){h_step, 0, r_step});
}

static void cross(crossings *all, const layout *lay)
{
    across xy = across_axis(lay);
    double rr = lay->r * lay->r, hh = lay->h * lay->h, z = lay->h - lay->p.z, d = lay->d.z;
    cross_flat(all, lay, 0);
    cross_round(all, lay, hh * xy.dd - rr * d * d, hh * xy.od + rr * z * d,
                hh * xy.oo - rr * z * z);
}

/* The wall goes outwards by w where the apex goes on by w / sin(angle) = w slant / r; the base's
 * circle grows with the height. */
static bool moved(const double *object, const movement *how, double *to)
{
    const double axis_way[3] = {object[3] - object[0], object[4] - object[1],
                                object[5] - object[2]};
    double base = how->by[0], wall = how->by[1], r = object[6];
    double h = hypot(hypot(axis_way[0], axis_way[1]), axis_way[2]), slant = hypot(r, h);
    double widest = (fabs(wall) * slant + fabs(base) * r) / h;
    moved_axis axis;
    if (!(r > 0) ||
        !moved_axis_of(object, 7, axis_way, fabs(base) + fabs(wall) * (1 + slant / r), &axis))
        return false;
    double height = h + base + wall * (slant / r);
    double more = moved_allowance(&axis, height, r + widest);
    if (more < 0)
        return false;
    base = moved_farther(base, more);
    wall = moved_farther(wall, more);
    moved_point(object, -base, axis.unit, to);
    moved_point(object + 3, wall * (slant / r), axis.unit, to + 3);
    to[6] = r + (wall * slant + base * r) / h;
    return h + base + wall * (slant / r) > 4 * more;
}

CASE_WALL(cone)

const case_shape case_cone = {
    CASE_CAPPED,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM | CASE_HAS_AXIS | CASE_HAS_HEIGHT | CASE_HAS_APEX,
    .tangent = tangent,
    .on_side = on_side,
    .enter_side = enter_wall,
    .cross = cross,
    .moved = moved,
    .wall_hit = wall_hit,
    .wall_side = wall_side,
};
