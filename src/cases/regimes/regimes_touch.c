/* SPDX-License-Identifier: MIT */
/* tangent, neighbour, grazing, on_surface, off_surface, rim, apex, far_tangent: what is only just
 * touched. In the frame of regimes_layout.h all is whole numbers, so the touching is exact. */
#include "../shapes/case_shape.h"

#include <math.h>

/* The ray's t at the point of interest: mostly ahead, at times at once, at times behind. */
static double random_touch_t(rng *g)
{
    return rng_chance(g, 1, 10) ? 0 : random_t(g);
}

/* A layout that is exactly tangent at p, its range open. */
static layout tangent_layout(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape};
    case_shape_of(shape)->tangent(&lay, g);
    lay.t = random_touch_t(g);
    return lay;
}

/* Anywhere, up to rounding, from so near that little is lost of what p says. */
static sure_case place_roughly(layout *lay, rng *g)
{
    double step = largest(lay->d);
    double distance = case_shape_of(lay->shape)->reach(lay) * rng_magnitude(g, -3, 8);
    lay->t = lay->t < 0 ? -distance / step : distance / step;
    range_usual(lay, g, distance / step);
    pose where = pose_general(lay->shape, g, 10);
    scale_anyhow(&where, 20, g);
    return place(lay, &where);
}

sure_case make_tangent(sure_shape shape, rng *g)
{
    layout lay = tangent_layout(shape, g);
    range_at_t(&lay, g);
    return place_exactly(&lay, g);
}

sure_case make_neighbour(sure_shape shape, rng *g)
{
    sure_case c = make_tangent(shape, g);
    if (rng_chance(g, 1, 2)) {
        c.ray.t_min = 0;
        c.ray.t_max = HUGE_VAL;
    }
    nudge(&c, g);
    return c;
}

/* +-2^-52 .. +-2^-6 */
static double random_delta(rng *g)
{
    double sign = rng_sign(g);
    return sign * rng_magnitude(g, -52, -6);
}

/* A ray that is nearly in the plane or disc, coming or going. */
static void tilt(layout *lay, rng *g)
{
    double length = fmax(fabs(lay->d.x), fabs(lay->d.y));
    lay->p.z = 0;
    lay->d.z = length * random_delta(g);
    if (case_shape_has(lay->shape, CASE_HAS_NO_END))
        lay->t *= rng_sign(g);
}

sure_case make_grazing(sure_shape shape, rng *g)
{
    layout lay = tangent_layout(shape, g);
    bool tilted = !case_shape_has(shape, CASE_HAS_INSIDE) &&
                  (case_shape_has(shape, CASE_HAS_NO_END) || rng_chance(g, 1, 2));
    if (tilted)
        tilt(&lay, g);
    double off = 1 + random_delta(g);
    if (tilted || rng_chance(g, 1, 2)) {
        lay.p.x *= off;
        return place_roughly(&lay, g);
    }
    /* Nothing but the radius is rounded, so that delta is what it says down to one ulp. */
    lay.r *= off;
    range_usual(&lay, g, fabs(lay.t));
    return place_exactly(&lay, g);
}

layout surface_layout(sure_shape shape, rng *g)
{
    layout lay = whole_layout(shape, g);
    const case_shape *row = case_shape_of(shape);
    bool side = rng_chance(g, 1, 2);
    (row->on_side && (side || !row->on_cap) ? row->on_side : row->on_cap)(&lay, g);
    /* As large as t d may be. */
    double factor = rng_whole(g, WAY_BITS + TIME_BITS - SIZE_BITS);
    lay.p = scaled(factor, lay.p);
    lay.r *= factor;
    lay.h *= factor;
    return lay;
}

/* Is t = 0 in the range, or is it cut off by as little as can be? Set in the world, where no scale
 * can round it away. */
static void range_at_0(sure_case *c, rng *g)
{
    int kind = rng_integer(g, 0, 9);
    if (kind <= 1 || kind == 4)
        c->ray.t_min = 0x1p-1074;
    else if (kind <= 3)
        c->ray.t_min = rng_magnitude(g, -60, -10);
    if (kind == 4)
        c->ray.t_max = rng_magnitude(g, -60, 10);
    else if (kind == 5)
        c->ray.t_max = 0;
}

/* Starts on the surface. */
static sure_case start_on_surface(sure_shape shape, rng *g)
{
    layout lay = surface_layout(shape, g);
    lay.d = rng_whole_vector(g, WAY_BITS);
    lay.t_max = HUGE_VAL;
    return place_exactly(&lay, g);
}

sure_case make_on_surface(sure_shape shape, rng *g)
{
    sure_case c = start_on_surface(shape, g);
    range_at_0(&c, g);
    return c;
}

sure_case make_off_surface(sure_shape shape, rng *g)
{
    sure_case c = start_on_surface(shape, g);
    step_start(&c, g);
    return c;
}

/* Half exactly through lay->p; a quarter that with one input moved by ulps; a quarter through a
 * point within delta of it, measured by `size`. */
static sure_case place_near(layout *lay, rng *g, double size)
{
    lay->d = rng_whole_vector(g, WAY_BITS);
    lay->t = random_touch_t(g);
    if (rng_chance(g, 1, 4)) {
        lay->p.x += size * random_delta(g);
        if (rng_chance(g, 1, 2))
            lay->p.z += size * random_delta(g);
        return place_roughly(lay, g);
    }
    return place_at_t(lay, pose_exact, 3, g);
}

/* The point p is on a rim; the rest is open. */
static layout rim_layout(sure_shape shape, rng *g)
{
    layout lay = whole_layout(shape, g);
    lay.p.x = lay.r;
    lay.p.z = random_cap(&lay, g);
    return lay;
}

sure_case make_rim(sure_shape shape, rng *g)
{
    layout lay = rim_layout(shape, g);
    return place_near(&lay, g, lay.r);
}

sure_case make_apex(sure_shape shape, rng *g)
{
    layout lay = whole_layout(shape, g);
    lay.p.z = lay.h;
    return place_near(&lay, g, lay.h);
}

layout touch_layout(sure_shape shape, rng *g)
{
    if (!case_shape_has(shape, CASE_HAS_RIM) || rng_chance(g, 1, 2))
        return tangent_layout(shape, g);
    layout lay = rim_layout(shape, g);
    lay.d = rng_whole_vector(g, WAY_BITS);
    lay.t = random_touch_t(g);
    return lay;
}

/* A plane is crossed, not touched: there the range decides. */
sure_case make_far_tangent(sure_shape shape, rng *g)
{
    layout lay;
    if (case_shape_has(shape, CASE_HAS_NO_END)) {
        lay = surface_layout(shape, g);
        lay.d = rng_whole_vector(g, WAY_BITS);
    } else {
        lay = touch_layout(shape, g);
    }
    double step = largest(lay.d);
    lay.t = floor(rng_magnitude(g, 20, 45) / step);
    return place_at_t(&lay, pose_exact_far, 2, g);
}
