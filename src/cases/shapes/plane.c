#include "case_shape.h"

/* In the plane, or beside it by a step that is small against its coordinates. */
static void tangent(layout *lay, draws *d)
{
    lay->r = draw_whole_size(d);
    lay->p.x = draw_offset(d, SIZE_BITS);
    lay->p.y = draw_offset(d, SIZE_BITS);
    lay->p.z = draw_chance(d, 3, 5) ? 0 : draw_sign(d);
    lay->d.x = draw_offset(d, WAY_BITS);
    lay->d.y = lay->d.x == 0 ? draw_signed(d, WAY_BITS) : draw_offset(d, WAY_BITS);
}

static void surface(layout *lay, bool side, draws *d)
{
    (void)side;
    lay->p.x = draw_offset(d, SIZE_BITS);
    lay->p.y = draw_offset(d, SIZE_BITS);
}

const case_shape case_plane = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_NO_END,
    .spoil = spoil_direction,
    .inner = draw_in_base,
    .boundary = draw_cap_point,
    .tangent = tangent,
    .surface = surface,
    .enter = enter_cap,
    .cross = cross_base,
    .small_objects = SMALL_VECTORS * (SMALL_VECTORS - 1),
};
