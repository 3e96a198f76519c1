#include "case_shape.h"

static void tangent(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    lay->h = random_whole_size(g);
    lay->p.x = lay->r;
    lay->p.z = random_side_height(lay->h, g);
    lay->d.y = rng_signed(g, WAY_BITS);
    lay->d.z = rng_offset(g, WAY_BITS);
}

static void surface(layout *lay, bool side, rng *g)
{
    if (side) {
        lay->p.x = lay->r;
        lay->p.z = random_within(lay->h, g);
    } else {
        surface_cap(lay, side, g);
    }
}

static void enter(layout *lay, rng *g)
{
    if (rng_chance(g, 1, 2))
        enter_side(lay, g);
    else
        enter_cap(lay, g);
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
    .inner = random_in_body,
    .boundary = random_boundary_point,
    .tangent = tangent,
    .surface = surface,
    .enter = enter,
    .cross = cross,
    .small_objects = 3 * SMALL_VECTORS * (SMALL_VECTORS - 1), /* radii 0 .. 2 */
};
