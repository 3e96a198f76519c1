/* SPDX-License-Identifier: MIT */
#include "case_shape.h"

static void anywhere(layout *lay, rng *g)
{
    lay->p.x = rng_offset(g, SIZE_BITS);
    lay->p.y = rng_offset(g, SIZE_BITS);
}

/* In the plane, or beside it by a step that is small against its coordinates. */
static void tangent(layout *lay, rng *g)
{
    lay->r = random_whole_size(g);
    anywhere(lay, g);
    lay->p.z = rng_chance(g, 3, 5) ? 0 : rng_sign(g);
    lay->d.x = rng_offset(g, WAY_BITS);
    lay->d.y = lay->d.x == 0 ? rng_signed(g, WAY_BITS) : rng_offset(g, WAY_BITS);
}

const case_shape case_plane = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_NO_END,
    .inner = random_in_base,
    .boundary = random_cap_point,
    .tangent = tangent,
    .on_cap = anywhere,
    .enter_cap = enter_cap,
    .cross = cross_base,
    .moved = moved_flat,
    .small_objects = SMALL_VECTORS * (SMALL_VECTORS - 1),
};
