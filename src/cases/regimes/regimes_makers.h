/* One maker a regime; regimes.c lists them by name. `d` is fresh: it knows seed, regime and
 * index. */
#ifndef CASES_REGIMES_MAKERS_H
#define CASES_REGIMES_MAKERS_H

#include "../shapes/case_shape.h"

/* regimes_size.c: what is large and what is small */
sure_case make_typical(sure_shape shape, rng *g);
sure_case make_inside(sure_shape shape, rng *g);
sure_case make_far(sure_shape shape, rng *g);
sure_case make_huge(sure_shape shape, rng *g);
sure_case make_tiny(sure_shape shape, rng *g);
sure_case make_nonunit(sure_shape shape, rng *g);
sure_case make_needle(sure_shape shape, rng *g);
sure_case make_coin(sure_shape shape, rng *g);
sure_case make_scaled_neighbour(sure_shape shape, rng *g);

/* regimes_touch.c: what is only just touched */
sure_case make_tangent(sure_shape shape, rng *g);
sure_case make_neighbour(sure_shape shape, rng *g);
sure_case make_grazing(sure_shape shape, rng *g);
sure_case make_on_surface(sure_shape shape, rng *g);
sure_case make_rim(sure_shape shape, rng *g);
sure_case make_apex(sure_shape shape, rng *g);
sure_case make_off_surface(sure_shape shape, rng *g);
sure_case make_far_tangent(sure_shape shape, rng *g);

/* A point p in whole numbers on the boundary; direction, t and range are left open. */
layout surface_layout(sure_shape shape, rng *g);

/* Exactly tangent at p, or through a point p of a rim; the range is left open. */
layout touch_layout(sure_shape shape, rng *g);

/* regimes_parallel.c: a leading coefficient that is 0 or nearly */
sure_case make_axis_parallel(sure_shape shape, rng *g);
sure_case make_wall_parallel(sure_shape shape, rng *g);
sure_case make_edge_on(sure_shape shape, rng *g);
sure_case make_nearly_parallel(sure_shape shape, rng *g);

/* regimes_time.c: a hit at the very end of the range, or between two doubles */
sure_case make_interval(sure_shape shape, rng *g);
sure_case make_midpoint(sure_shape shape, rng *g);

/* regimes_degenerate.c, regimes_integers.c, regimes_bits.c */
sure_case make_degenerate(sure_shape shape, rng *g);
sure_case make_integers(sure_shape shape, rng *g);
sure_case make_bits(sure_shape shape, rng *g);

#endif
