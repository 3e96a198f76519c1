/* SPDX-License-Identifier: MIT */
#include "regimes.h"

#include <stdio.h>
#include <string.h>

#include "shapes/case_shape.h"

#define REGIME(NAME, name, key, of) {#name, key, of, make_##name},
static const struct {
    const char *name;
    uint64_t key;
    unsigned of;
    sure_case (*make)(sure_shape shape, rng *g);
} regimes[REGIMES] = {
#include "regimes.def"
};

const char *regime_name(regime which)
{
    return (unsigned)which < REGIMES ? regimes[which].name : NULL;
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

int regime_remarked(const char *line, regime *which)
{
    char word[32];
    const char *remark = strchr(line, '#');
    return remark && sscanf(remark, "# %31s", word) == 1 && regime_from_name(word, which);
}

int regime_applies(sure_shape shape, regime which)
{
    return (unsigned)which < REGIMES && (unsigned)shape < SURE_SHAPES &&
           case_shape_has(shape, regimes[which].of);
}

bool regime_rows_have(const regime_rows *asked, int shape, int which)
{
    return (asked->shapes[shape] || !asked->some_shapes) &&
           (asked->regimes[which] || !asked->some_regimes) &&
           (!asked->set || case_set_has(asked->set, sure_shape_name((sure_shape)shape),
                                        regime_name((regime)which))) &&
           regime_applies((sure_shape)shape, (regime)which) != 0;
}

rng regime_rng(sure_shape shape, regime which, uint64_t seed, uint64_t index)
{
    return rng_of(seed, (uint64_t)shape, regimes[which].key, index);
}

sure_case regime_case(sure_shape shape, regime which, uint64_t seed, uint64_t index)
{
    rng g = regime_rng(shape, which, seed, index);
    return regimes[which].make(shape, &g);
}
