/* SPDX-License-Identifier: MIT */
#include "sets.h"

#include <stddef.h>
#include <string.h>

#define SIX_SHAPES "plane disc sphere cylinder cone box"
#define REGIMES_2026_1                                                                             \
    "camera typical grazing tangent neighbour far huge tiny inside on_surface rim apex "           \
    "axis_parallel wall_parallel edge_on needle coin degenerate interval midpoint nonunit "        \
    "integers bits off_surface nearly_parallel far_tangent scaled_neighbour"

const case_set case_sets[] = {
    {"2026.1", 20261, 1000, SIX_SHAPES, REGIMES_2026_1,
     "6c8c7581713689f84b3233e8e99604aa8d0e9c59dac8fa3aaa4209bfaa701cf4"},
    {"2026.2", 20262, 1000, SIX_SHAPES, REGIMES_2026_1 " scales",
     "603cb7931c3758bb2730f4b85320b0075c75eb8490f9a2ad43bc6aca68e7697d"},
    {NULL, 0, 0, NULL, NULL, NULL},
};

static bool has_word(const char *words, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = words; *at != '\0'; at += strcspn(at, " "), at += *at == ' ') {
        if (strcspn(at, " ") == length && memcmp(at, word, length) == 0)
            return true;
    }
    return false;
}

bool case_set_has(const case_set *set, const char *shape, const char *regime)
{
    return has_word(set->shapes, shape) && has_word(set->regimes, regime);
}
