#include "regimes.h"

#include <string.h>

#include "regimes/regimes_makers.h"

#define ON(shape) (1u << (shape))
#define SPHERE ON(SURE_SHAPE_SPHERE)
#define CYLINDER ON(SURE_SHAPE_CYLINDER)
#define CONE ON(SURE_SHAPE_CONE)
#define SOLIDS (SPHERE | CYLINDER | CONE)
#define ROUND (ON(SURE_SHAPE_DISC) | CYLINDER | CONE) /* with a rim */
#define FLAT (ON(SURE_SHAPE_PLANE) | ON(SURE_SHAPE_DISC))
#define ALL (FLAT | SOLIDS)

static const struct {
    const char *name;
    unsigned shapes; /* for which it means anything */
    sure_case (*make)(sure_shape shape, draws *d);
} regimes[REGIMES] = {
    [REGIME_TYPICAL] = {"typical", ALL, make_typical},
    [REGIME_GRAZING] = {"grazing", ALL, make_grazing},
    [REGIME_TANGENT] = {"tangent", ALL, make_tangent},
    [REGIME_NEIGHBOUR] = {"neighbour", ALL, make_neighbour},
    [REGIME_FAR] = {"far", ALL, make_far},
    [REGIME_HUGE] = {"huge", ALL, make_huge},
    [REGIME_TINY] = {"tiny", ALL, make_tiny},
    [REGIME_INSIDE] = {"inside", SOLIDS, make_inside},
    [REGIME_ON_SURFACE] = {"on_surface", ALL, make_on_surface},
    [REGIME_RIM] = {"rim", ROUND, make_rim},
    [REGIME_APEX] = {"apex", CONE, make_apex},
    [REGIME_AXIS_PARALLEL] = {"axis_parallel", CYLINDER | CONE, make_axis_parallel},
    [REGIME_WALL_PARALLEL] = {"wall_parallel", CONE, make_wall_parallel},
    [REGIME_EDGE_ON] = {"edge_on", ROUND, make_edge_on},
    [REGIME_NEEDLE] = {"needle", CYLINDER | CONE, make_needle},
    [REGIME_COIN] = {"coin", CYLINDER | CONE, make_coin},
    [REGIME_DEGENERATE] = {"degenerate", ALL, make_degenerate},
    [REGIME_INTERVAL] = {"interval", ALL, make_interval},
    [REGIME_MIDPOINT] = {"midpoint", ALL, make_midpoint},
    [REGIME_NONUNIT] = {"nonunit", ALL, make_nonunit},
    [REGIME_INTEGERS] = {"integers", ALL, make_integers},
    [REGIME_BITS] = {"bits", ALL, make_bits},
    [REGIME_OFF_SURFACE] = {"off_surface", ALL, make_off_surface},
    [REGIME_NEARLY_PARALLEL] = {"nearly_parallel", FLAT | CYLINDER | CONE, make_nearly_parallel},
    [REGIME_FAR_TANGENT] = {"far_tangent", ALL, make_far_tangent},
    [REGIME_SCALED_NEIGHBOUR] = {"scaled_neighbour", ALL, make_scaled_neighbour},
};

static int is_regime(regime which)
{
    return (unsigned)which < REGIMES;
}

const char *regime_name(regime which)
{
    return is_regime(which) ? regimes[which].name : NULL;
}

int regime_from_name(const char *name, regime *which)
{
    for (int i = 0; i < REGIMES; i++) {
        if (strcmp(name, regimes[i].name) == 0) {
            *which = (regime)i;
            return 1;
        }
    }
    return 0;
}

int regime_applies(sure_shape shape, regime which)
{
    return is_regime(which) && (unsigned)shape < SURE_SHAPES &&
           (regimes[which].shapes & ON(shape)) != 0;
}

sure_case regime_case(sure_shape shape, regime which, uint64_t seed, uint64_t index)
{
    draws d = draws_of(seed, (uint64_t)shape, (uint64_t)which, index);
    return regimes[which].make(shape, &d);
}
