#include "case_shape.h"

static sure_vec3 inner(const layout *lay, draws *d)
{
    double f = draw_between(d, 0, 1);
    return draw_in_circle(d, lay->r, f * lay->h);
}

static boundary_point boundary(const layout *lay, draws *d)
{
    if (!draw_chance(d, 1, 2))
        return draw_cap_point(lay, d);
    double f = draw_between(d, 0, 1);
    sure_vec3 out = draw_on_circle(d);
    return (boundary_point){{lay->r * out.x, lay->r * out.y, f * lay->h}, out};
}

static void tangent(layout *lay, draws *d)
{
    lay->r = draw_whole_size(d);
    lay->h = draw_whole_size(d);
    lay->p.x = lay->r;
    lay->p.z = draw_side_height(lay->h, d);
    lay->d.y = draw_signed(d, WAY_BITS);
    lay->d.z = draw_offset(d, WAY_BITS);
}

static void surface(layout *lay, bool side, draws *d)
{
    if (side) {
        lay->p.x = lay->r;
        lay->p.z = draw_within(lay->h, d);
    } else {
        surface_cap(lay, side, d);
    }
}

static void enter(layout *lay, draws *d)
{
    if (draw_chance(d, 1, 2))
        enter_side(lay, d);
    else
        enter_cap(lay, d);
}

static void cross(crossings *all, const layout *lay)
{
    across xy = across_axis(lay);
    cross_flat(all, lay, 0);
    cross_flat(all, lay, lay->h);
    cross_round(all, lay, xy.dd, xy.od, xy.oo - lay->r * lay->r);
}

const case_shape case_cylinder = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM | CASE_HAS_AXIS | CASE_HAS_HEIGHT | CASE_HAS_TWO_CAPS,
    .spoil = spoil_end,
    .inner = inner,
    .boundary = boundary,
    .tangent = tangent,
    .surface = surface,
    .enter = enter,
    .cross = cross,
    .small_objects = 3 * SMALL_VECTORS * (SMALL_VECTORS - 1), /* radii 0 .. 2 */
};
