#include "regimes.h"

#include <string.h>

#include "shapes/case_shape.h"

#define REGIME(NAME, name, of) {#name, of, make_##name},
static const struct {
    const char *name;
    unsigned of;
    sure_case (*make)(sure_shape shape, rng *g);
} regimes[REGIMES] = {
#include "regimes.def"
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

bool regime_rows_have(const regime_rows *asked, int shape, int which)
{
    return (asked->shapes[shape] || !asked->some_shapes) &&
           (asked->regimes[which] || !asked->some_regimes) &&
           regime_applies((sure_shape)shape, (regime)which) != 0;
}

sure_case regime_case(sure_shape shape, regime which, uint64_t seed, uint64_t index)
{
    rng g = rng_of(seed, (uint64_t)shape, (uint64_t)which, index);
    return regimes[which].make(shape, &g);
}
