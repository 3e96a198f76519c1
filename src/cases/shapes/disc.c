#include <math.h>

#include "case_shape.h"

/* In a quarter of draws off the disc. */
static void enter(layout *lay, rng *g)
{
    double x = floor(rng_between(g, 0, lay->r));
    if (rng_chance(g, 1, 4))
        x += lay->r;
    enter_flat(lay, false, x, g);
}

const case_shape case_disc = {
    CASE_ON_AXIS,
    .has = CASE_HAS_FLAT | CASE_HAS_RIM,
    .inner = random_in_base,
    .boundary = random_cap_point,
    .tangent = tangent_at_rim,
    .on_cap = on_cap,
    .enter_cap = enter,
    .cross = cross_base,
    .small_objects = 4 * SMALL_VECTORS * (SMALL_VECTORS - 1), /* radii 0 .. 3 */
};
