/* tangent, neighbour, grazing, on_surface, off_surface, rim, apex, far_tangent: what is only just
 * touched. In the frame of regimes_layout.h all is whole numbers, so the touching is exact. */
#include "regimes_makers.h"

#include <math.h>

/* The ray's t at the point of interest: mostly ahead, at times at once, at times behind. */
static double draw_touch_t(draws *d)
{
    if (draw_chance(d, 1, 10))
        return 0;
    double t = draw_whole(d, TIME_BITS);
    return draw_chance(d, 1, 10) ? -t : t;
}

/* A layout that is exactly tangent at p, its range open. */
static layout tangent_layout(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape};
    case_shape_of(shape)->tangent(&lay, d);
    lay.t = draw_touch_t(d);
    return lay;
}

static sure_case place_exactly(const layout *lay, draws *d)
{
    pose where = pose_exact(lay->shape, d);
    return place(lay, &where);
}

/* Anywhere, up to rounding, from so near that little is lost of what p says. */
static sure_case place_roughly(layout *lay, draws *d)
{
    double step = fmax(fabs(lay->d.x), fmax(fabs(lay->d.y), fabs(lay->d.z)));
    double distance = reach(lay) * draw_magnitude(d, -3, 8);
    lay->t = lay->t < 0 ? -distance / step : distance / step;
    range_usual(lay, d, distance / step);
    pose where = pose_general(lay->shape, d, 10);
    where.scale = draw_integer(d, -20, 20);
    where.d_scale = draw_integer(d, -20, 20);
    where.n_scale = draw_integer(d, -20, 20);
    return place(lay, &where);
}

sure_case make_tangent(sure_shape shape, draws *d)
{
    layout lay = tangent_layout(shape, d);
    range_at_t(&lay, d);
    return place_exactly(&lay, d);
}

sure_case make_neighbour(sure_shape shape, draws *d)
{
    sure_case c = make_tangent(shape, d);
    if (draw_chance(d, 1, 2)) {
        c.ray.t_min = 0;
        c.ray.t_max = HUGE_VAL;
    }
    nudge(&c, d);
    return c;
}

/* +-2^-52 .. +-2^-6 */
static double draw_delta(draws *d)
{
    double sign = draw_sign(d);
    return sign * draw_magnitude(d, -52, -6);
}

/* A ray that is nearly in the plane or disc, coming or going. */
static void tilt(layout *lay, draws *d)
{
    double length = fmax(fabs(lay->d.x), fabs(lay->d.y));
    lay->p.z = 0;
    lay->d.z = length * draw_delta(d);
    if (case_shape_has(lay->shape, CASE_HAS_NO_END))
        lay->t *= draw_sign(d);
}

sure_case make_grazing(sure_shape shape, draws *d)
{
    layout lay = tangent_layout(shape, d);
    bool tilted = !case_shape_has(shape, CASE_HAS_INSIDE) &&
                  (case_shape_has(shape, CASE_HAS_NO_END) || draw_chance(d, 1, 2));
    if (tilted)
        tilt(&lay, d);
    double off = 1 + draw_delta(d);
    if (tilted || draw_chance(d, 1, 2)) {
        lay.p.x *= off;
        return place_roughly(&lay, d);
    }
    /* Nothing but the radius is rounded, so that delta is what it says down to one ulp. */
    lay.r *= off;
    range_usual(&lay, d, fabs(lay.t));
    return place_exactly(&lay, d);
}

layout surface_layout(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    if (has_height(shape))
        lay.h = draw_whole_size(d);
    case_shape_of(shape)->surface(&lay, draw_chance(d, 1, 2), d);
    /* As large as t d may be. */
    double factor = draw_whole(d, WAY_BITS + TIME_BITS - SIZE_BITS);
    lay.p = scaled(factor, lay.p);
    lay.r *= factor;
    lay.h *= factor;
    return lay;
}

/* Is t = 0 in the range, or is it cut off by as little as can be? Set in the world, where no scale
 * can round it away. */
static void range_at_0(sure_ray *ray, draws *d)
{
    switch (draw_integer(d, 0, 9)) {
    case 0:
    case 1: ray->t_min = 0x1p-1074; break;
    case 2:
    case 3: ray->t_min = draw_magnitude(d, -60, -10); break;
    case 4:
        ray->t_min = 0x1p-1074;
        ray->t_max = draw_magnitude(d, -60, 10);
        break;
    case 5: ray->t_max = 0; break;
    default: break;
    }
}

sure_case make_on_surface(sure_shape shape, draws *d)
{
    layout lay = surface_layout(shape, d);
    lay.d = draw_whole_vector(d, WAY_BITS);
    lay.t_max = HUGE_VAL;
    sure_case c = place_exactly(&lay, d);
    range_at_0(&c.ray, d);
    return c;
}

/* Half exactly through lay->p; a quarter that with one input moved by ulps; a quarter through a
 * point within delta of it, measured by `size`. */
static sure_case place_near(layout *lay, draws *d, double size)
{
    lay->d = draw_whole_vector(d, WAY_BITS);
    lay->t = draw_touch_t(d);
    if (draw_chance(d, 1, 4)) {
        lay->p.x += size * draw_delta(d);
        if (draw_chance(d, 1, 2))
            lay->p.z += size * draw_delta(d);
        return place_roughly(lay, d);
    }
    range_at_t(lay, d);
    sure_case c = place_exactly(lay, d);
    if (draw_chance(d, 1, 3))
        nudge(&c, d);
    return c;
}

/* The point p is on a rim; the rest is open. */
static layout rim_layout(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    if (has_height(shape))
        lay.h = draw_whole_size(d);
    lay.p.x = lay.r;
    lay.p.z = draw_cap(&lay, d);
    return lay;
}

sure_case make_rim(sure_shape shape, draws *d)
{
    layout lay = rim_layout(shape, d);
    return place_near(&lay, d, lay.r);
}

sure_case make_apex(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    lay.h = draw_whole_size(d);
    lay.p.z = lay.h;
    return place_near(&lay, d, lay.h);
}

layout touch_layout(sure_shape shape, draws *d)
{
    if (!case_shape_has(shape, CASE_HAS_RIM) || draw_chance(d, 1, 2))
        return tangent_layout(shape, d);
    layout lay = rim_layout(shape, d);
    lay.d = draw_whole_vector(d, WAY_BITS);
    lay.t = draw_touch_t(d);
    return lay;
}

sure_case make_off_surface(sure_shape shape, draws *d)
{
    layout lay = surface_layout(shape, d);
    lay.d = draw_whole_vector(d, WAY_BITS);
    lay.t_max = HUGE_VAL;
    sure_case c = place_exactly(&lay, d);
    double *start[3] = {&c.ray.origin.x, &c.ray.origin.y, &c.ray.origin.z};
    double *moved = start[draw_integer(d, 0, 2)];
    *moved = step_ulps(*moved, (int)draw_sign(d));
    return c;
}

/* A plane is crossed, not touched: there the range decides. */
sure_case make_far_tangent(sure_shape shape, draws *d)
{
    layout lay;
    if (case_shape_has(shape, CASE_HAS_NO_END)) {
        lay = surface_layout(shape, d);
        lay.d = draw_whole_vector(d, WAY_BITS);
    } else {
        lay = touch_layout(shape, d);
    }
    double step = fmax(fabs(lay.d.x), fmax(fabs(lay.d.y), fabs(lay.d.z)));
    lay.t = floor(draw_magnitude(d, 20, 45) / step);
    range_at_t(&lay, d);
    pose where = pose_exact_far(shape, d);
    sure_case c = place(&lay, &where);
    if (draw_chance(d, 1, 2))
        nudge(&c, d);
    return c;
}
