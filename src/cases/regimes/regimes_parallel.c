/* SPDX-License-Identifier: MIT */
/* axis_parallel, wall_parallel, edge_on, nearly_parallel: a leading coefficient that is 0 or
 * nearly. */
#include "../shapes/case_shape.h"

#include <math.h>

/* Exactly as laid out in whole numbers; or that with one input moved by ulps; or with a direction
 * that is off by 2^-60 .. 2^-7, placed anywhere: a third of draws each. */
static sure_case place_parallel(layout *lay, rng *g)
{
    if (rng_chance(g, 1, 3)) {
        double length = largest(lay->d);
        double off = length * rng_magnitude(g, -60, -7);
        lay->d = sum_of(lay->d, off, rng_unit(g));
        range_usual(lay, g, fabs(lay->t));
        return place_generally(lay, g, 10);
    }
    return place_at_t(lay, pose_exact, 2, g);
}

/* A whole distance from the axis: on it, within r, on the circle itself, beside it by one step or
 * more. */
static double random_distance(double r, rng *g)
{
    switch (rng_integer(g, 0, 5)) {
    case 0: return 0;
    case 1: return floor(rng_between(g, 0, r));
    case 2:
    case 3: return r;
    case 4: return r + 1;
    default: return r + rng_whole(g, SIZE_BITS);
    }
}

sure_case make_axis_parallel(sure_shape shape, rng *g)
{
    layout lay = whole_layout(shape, g);
    lay.p.x = random_distance(lay.r, g);
    lay.p.z = rng_chance(g, 1, 2) ? 0 : lay.h;
    lay.d.z = rng_signed(g, WAY_BITS);
    lay.t = random_t(g);
    return place_parallel(&lay, g);
}

/* Where a line parallel to the generator through (r, 0, 0) and (0, 0, h) crosses the base's plane:
 * on the generator itself, beside it in the plane that touches there, or at any distance from the
 * axis. */
static sure_vec3 random_wall_crossing(double r, rng *g)
{
    sure_vec3 p = {r, 0, 0};
    switch (rng_integer(g, 0, 5)) {
    case 0:
    case 1: break;
    case 2: p.y = rng_signed(g, SIZE_BITS); break;
    default:
        p.x = rng_sign(g);
        p.x *= random_distance(r, g);
        break;
    }
    return p;
}

/* Cone only. */
sure_case make_wall_parallel(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape};
    double r_step = rng_whole(g, STEP_BITS);
    double h_step = rng_whole(g, STEP_BITS);
    double parts = rng_whole(g, PART_BITS);
    lay.r = parts * r_step;
    lay.h = parts * h_step;
    lay.p = random_wall_crossing(lay.r, g);
    double speed = rng_signed(g, WAY_BITS - STEP_BITS);
    lay.d.x = -speed * r_step;
    lay.d.z = speed * h_step;
    lay.t = random_t(g);
    return place_parallel(&lay, g);
}

/* In the plane of a cap: along a chord, along a tangent of its circle, or beside it. */
sure_case make_edge_on(sure_shape shape, rng *g)
{
    layout lay = whole_layout(shape, g);
    lay.p.x = random_distance(lay.r, g);
    lay.p.z = random_cap(&lay, g);
    lay.d.y = rng_signed(g, WAY_BITS);
    lay.d.x = lay.p.x == lay.r ? 0 : rng_offset(g, WAY_BITS);
    lay.t = random_t(g);
    return place_parallel(&lay, g);
}

/* A step through the plane, or aside of the axis, for 2^20 .. 2^30 along it; in whole numbers. */
sure_case make_nearly_parallel(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .r = random_whole_size(g)};
    double far = floor(rng_magnitude(g, 20, 30));
    double step = rng_sign(g);
    lay.p.x = random_distance(lay.r, g);
    if (case_shape_has(shape, CASE_HAS_HEIGHT)) {
        lay.h = random_whole_size(g);
        lay.p.z = random_cap(&lay, g);
        lay.d.x = step;
        lay.d.z = far * rng_sign(g);
    } else {
        lay.d.x = far;
        lay.d.y = rng_offset(g, 7);
        lay.d.z = step;
    }
    lay.t = random_t(g);
    return place_at_t(&lay, pose_exact_far, 2, g);
}
