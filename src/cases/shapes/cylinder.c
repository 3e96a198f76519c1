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

const case_shape case_cylinder = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM | CASE_HAS_AXIS | CASE_HAS_HEIGHT | CASE_HAS_TWO_CAPS,
    .inner = random_in_body,
    .boundary = random_boundary_point,
    .tangent = tangent,
    .on_side = on_side,
    .on_cap = on_cap,
    .enter_side = enter_side,
    .enter_cap = enter_cap,
    .cross = cross,
    .small_objects = 3 * SMALL_VECTORS * (SMALL_VECTORS - 1), /* radii 0 .. 2 */
};
