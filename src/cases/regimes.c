#include "regimes.h"

#include <string.h>

#include "regimes/regimes_makers.h"

static const struct {
    const char *name;
    unsigned of; /* what a shape must have for it to mean anything */
    sure_case (*make)(sure_shape shape, rng *g);
} regimes[REGIMES] = {
    [REGIME_TYPICAL] = {"typical", 0, make_typical},
    [REGIME_GRAZING] = {"grazing", 0, make_grazing},
    [REGIME_TANGENT] = {"tangent", 0, make_tangent},
    [REGIME_NEIGHBOUR] = {"neighbour", 0, make_neighbour},
    [REGIME_FAR] = {"far", 0, make_far},
    [REGIME_HUGE] = {"huge", 0, make_huge},
    [REGIME_TINY] = {"tiny", 0, make_tiny},
    [REGIME_INSIDE] = {"inside", CASE_HAS_INSIDE, make_inside},
    [REGIME_ON_SURFACE] = {"on_surface", 0, make_on_surface},
    [REGIME_RIM] = {"rim", CASE_HAS_RIM, make_rim},
    [REGIME_APEX] = {"apex", CASE_HAS_APEX, make_apex},
    [REGIME_AXIS_PARALLEL] = {"axis_parallel", CASE_HAS_AXIS, make_axis_parallel},
    [REGIME_WALL_PARALLEL] = {"wall_parallel", CASE_HAS_APEX, make_wall_parallel},
    [REGIME_EDGE_ON] = {"edge_on", CASE_HAS_RIM, make_edge_on},
    [REGIME_NEEDLE] = {"needle", CASE_HAS_AXIS, make_needle},
    [REGIME_COIN] = {"coin", CASE_HAS_AXIS, make_coin},
    [REGIME_DEGENERATE] = {"degenerate", 0, make_degenerate},
    [REGIME_INTERVAL] = {"interval", 0, make_interval},
    [REGIME_MIDPOINT] = {"midpoint", 0, make_midpoint},
    [REGIME_NONUNIT] = {"nonunit", 0, make_nonunit},
    [REGIME_INTEGERS] = {"integers", 0, make_integers},
    [REGIME_BITS] = {"bits", 0, make_bits},
    [REGIME_OFF_SURFACE] = {"off_surface", 0, make_off_surface},
    [REGIME_NEARLY_PARALLEL] = {"nearly_parallel", CASE_HAS_FLAT, make_nearly_parallel},
    [REGIME_FAR_TANGENT] = {"far_tangent", 0, make_far_tangent},
    [REGIME_SCALED_NEIGHBOUR] = {"scaled_neighbour", 0, make_scaled_neighbour},
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
           case_shape_has(shape, regimes[which].of);
}

sure_case regime_case(sure_shape shape, regime which, uint64_t seed, uint64_t index)
{
    rng g = rng_of(seed, (uint64_t)shape, (uint64_t)which, index);
    return regimes[which].make(shape, &g);
}
