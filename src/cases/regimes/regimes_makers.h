/* One maker a regime. `g` is fresh: it knows seed, regime and index. */
#ifndef CASES_REGIMES_MAKERS_H
#define CASES_REGIMES_MAKERS_H

#include "../shapes/case_shape.h"

#define REGIME(NAME, name, of) sure_case make_##name(sure_shape shape, rng *g);
#include "../regimes.def"
#undef REGIME

/* A point p in whole numbers on the boundary; direction, t and range are left open. */
layout surface_layout(sure_shape shape, rng *g);

/* Exactly tangent at p, or through a point p of a rim; the range is left open. */
layout touch_layout(sure_shape shape, rng *g);

#endif
