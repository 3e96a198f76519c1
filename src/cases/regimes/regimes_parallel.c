/* axis_parallel, wall_parallel, edge_on, nearly_parallel: a leading coefficient that is 0 or
 * nearly. */
#include "regimes_makers.h"

#include <math.h>

/* Exactly as laid out in whole numbers; or that with one input moved by ulps; or with a direction
 * that is off by 2^-60 .. 2^-7, placed anywhere: a third of draws each. */
static sure_case place_parallel(layout *lay, draws *d)
{
    if (draw_chance(d, 1, 3)) {
        double length = fmax(fabs(lay->d.x), fmax(fabs(lay->d.y), fabs(lay->d.z)));
        double off = length * draw_magnitude(d, -60, -7);
        lay->d = along(lay->d, off, draw_unit(d));
        range_usual(lay, d, fabs(lay->t));
        pose where = pose_general(lay->shape, d, 10);
        return place(lay, &where);
    }
    range_at_t(lay, d);
    pose where = pose_exact(lay->shape, d);
    sure_case c = place(lay, &where);
    if (draw_chance(d, 1, 2))
        nudge(&c, d);
    return c;
}

static double draw_t(draws *d)
{
    double t = draw_whole(d, TIME_BITS);
    return draw_chance(d, 1, 10) ? -t : t;
}

/* A whole distance from the axis: on it, within r, on the circle itself, beside it by one step or
 * more. */
static double draw_distance(double r, draws *d)
{
    switch (draw_integer(d, 0, 5)) {
    case 0: return 0;
    case 1: return floor(draw_between(d, 0, r));
    case 2:
    case 3: return r;
    case 4: return r + 1;
    default: return r + draw_whole(d, SIZE_BITS);
    }
}

sure_case make_axis_parallel(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    lay.h = draw_whole_size(d);
    lay.p.x = draw_distance(lay.r, d);
    lay.p.z = draw_chance(d, 1, 2) ? 0 : lay.h;
    lay.d.z = draw_signed(d, WAY_BITS);
    lay.t = draw_t(d);
    return place_parallel(&lay, d);
}

/* Where a line parallel to the generator through (r, 0, 0) and (0, 0, h) crosses the base's plane:
 * on the generator itself, beside it in the plane that touches there, or at any distance from the
 * axis. */
static sure_vec3 draw_wall_crossing(double r, draws *d)
{
    sure_vec3 p = {r, 0, 0};
    switch (draw_integer(d, 0, 5)) {
    case 0:
    case 1: break;
    case 2: p.y = draw_signed(d, SIZE_BITS); break;
    default:
        p.x = draw_sign(d);
        p.x *= draw_distance(r, d);
        break;
    }
    return p;
}

/* Cone only. */
sure_case make_wall_parallel(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape};
    double r_step = draw_whole(d, STEP_BITS);
    double h_step = draw_whole(d, STEP_BITS);
    double parts = draw_whole(d, PART_BITS);
    lay.r = parts * r_step;
    lay.h = parts * h_step;
    lay.p = draw_wall_crossing(lay.r, d);
    double speed = draw_signed(d, WAY_BITS - STEP_BITS);
    lay.d.x = -speed * r_step;
    lay.d.z = speed * h_step;
    lay.t = draw_t(d);
    return place_parallel(&lay, d);
}

/* In the plane of a cap: along a chord, along a tangent of its circle, or beside it. */
sure_case make_edge_on(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    if (has_height(shape))
        lay.h = draw_whole_size(d);
    lay.p.x = draw_distance(lay.r, d);
    lay.p.z = draw_cap(&lay, d);
    lay.d.y = draw_signed(d, WAY_BITS);
    lay.d.x = lay.p.x == lay.r ? 0 : draw_offset(d, WAY_BITS);
    lay.t = draw_t(d);
    return place_parallel(&lay, d);
}

/* A step through the plane, or aside of the axis, for 2^20 .. 2^30 along it; in whole numbers. */
sure_case make_nearly_parallel(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    double far = floor(draw_magnitude(d, 20, 30));
    double step = draw_sign(d);
    lay.p.x = draw_distance(lay.r, d);
    if (has_height(shape)) {
        lay.h = draw_whole_size(d);
        lay.p.z = draw_cap(&lay, d);
        lay.d.x = step;
        lay.d.z = far * draw_sign(d);
    } else {
        lay.d.x = far;
        lay.d.y = draw_offset(d, 7);
        lay.d.z = step;
    }
    lay.t = draw_t(d);
    range_at_t(&lay, d);
    pose where = pose_exact_far(shape, d);
    sure_case c = place(&lay, &where);
    if (draw_chance(d, 1, 2))
        nudge(&c, d);
    return c;
}
