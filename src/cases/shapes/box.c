/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "../../geometry/coordinate.h"
#include "case_shape.h"

/* In the frame from (-r, -r, 0) to (r, r, h); it can't be turned. */
static sure_mat3 turn_none(const double q[4])
{
    double n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    return (sure_mat3){{{n, 0, 0}, {0, n, 0}, {0, 0, n}}};
}

static void corners(const layout *lay, sure_vec3 point[2])
{
    point[0] = (sure_vec3){-lay->r, -lay->r, 0};
    point[1] = (sure_vec3){lay->r, lay->r, lay->h};
}

static double reach_of_corner(const layout *lay)
{
    return sqrt(2 * lay->r * lay->r + lay->h * lay->h);
}

static sure_vec3 inner(const layout *lay, rng *g)
{
    sure_vec3 p;
    p.x = lay->r * rng_between(g, -1, 1);
    p.y = lay->r * rng_between(g, -1, 1);
    p.z = lay->h * rng_between(g, 0, 1);
    return p;
}

static boundary_point boundary(const layout *lay, rng *g)
{
    boundary_point at = {inner(lay, g), {0, 0, 0}};
    double sign = rng_sign(g);
    int axis = rng_integer(g, 0, 2);
    *coordinate_of(&at.p, axis) = axis < 2 ? sign * lay->r : sign > 0 ? lay->h : 0;
    *coordinate_of(&at.normal, axis) = sign;
    return at;
}

/* Along the edge through (r, r, 0), past it, or in the plane of a face. */
static void tangent(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    lay->h = random_whole_size(g);
    lay->p = (sure_vec3){lay->r, lay->r, random_side_height(lay->h, g)};
    lay->d.x = rng_chance(g, 1, 2) ? 0 : rng_whole(g, WAY_BITS);
    lay->d.y = -rng_whole(g, WAY_BITS);
    lay->d.z = rng_offset(g, WAY_BITS);
}

/* On an edge, mostly: elsewhere few neighbours of a point are off the surface. */
static void on_side(layout *lay, rng *g)
{
    lay->p.x = lay->r;
    lay->p.y = rng_chance(g, 7, 8) ? lay->r : random_within(lay->r, g);
    lay->p.z = random_within(lay->h, g);
}

static void on_lid(layout *lay, rng *g)
{
    lay->p.x = rng_chance(g, 7, 8) ? lay->r : random_within(lay->r, g);
    lay->p.y = random_within(lay->r, g);
    lay->p.z = random_cap(lay, g);
}

static void cross(crossings *all, const layout *lay)
{
    const double o[3] = {lay->p.x, lay->p.y, lay->p.z}, d[3] = {lay->d.x, lay->d.y, lay->d.z};
    const double low[3] = {-lay->r, -lay->r, 0}, high[3] = {lay->r, lay->r, lay->h};
    for (int i = 0; i < 6; i++) {
        int axis = i / 2, second = (axis + 1) % 3, third = (axis + 2) % 3;
        double t = ((i % 2 ? high[axis] : low[axis]) - o[axis]) / d[axis];
        double u = o[second] + t * d[second], v = o[third] + t * d[third];
        if (d[axis] != 0 && t > 0 && u >= low[second] && u <= high[second] && v >= low[third] &&
            v <= high[third])
            all->t[all->count++] = t;
    }
}

/* Of each coordinate's six pairs low <= high of -1, 0, 1 one. */
static void small_box(sure_case *c, uint64_t code)
{
    static const double pairs[6][2] = {{-1, -1}, {-1, 0}, {-1, 1}, {0, 0}, {0, 1}, {1, 1}};
    for (int i = 0; i < 3; i++, code /= 6) {
        *case_number(c, AT_OBJECT + i) = pairs[code % 6][0];
        *case_number(c, AT_OBJECT + 3 + i) = pairs[code % 6][1];
    }
}

/* The parts are x_min, x_max, y_min, ... */
static bool moved(const double *object, const movement *how, double *to)
{
    for (int i = 0; i < 3; i++) {
        double low = how->by[2 * i], high = how->by[2 * i + 1];
        to[i] = nextafter(object[i] - low, low < 0 ? INFINITY : -INFINITY);
        to[3 + i] = nextafter(object[3 + i] + high, high < 0 ? -INFINITY : INFINITY);
    }
    return true;
}

const case_shape case_box = {
    .has = CASE_HAS_FLAT | CASE_HAS_RIM | CASE_HAS_AXIS | CASE_HAS_HEIGHT | CASE_HAS_TWO_CAPS,
    .turn = turn_none,
    .points = corners,
    .reach = reach_of_corner,
    .inner = inner,
    .boundary = boundary,
    .tangent = tangent,
    .on_side = on_side,
    .on_cap = on_lid,
    .enter_side = enter_side,
    .enter_cap = enter_cap,
    .cross = cross,
    .moved = moved,
    .small_objects = 6 * 6 * 6,
    .small_object = small_box,
};
