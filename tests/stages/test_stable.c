/* SPDX-License-Identifier: MIT */
/* The stable tier's promises (docs/proofs/stable.md) of what is no shape. A shape's stable is the
 * first stage of certain, which the shape's laws hold it to. */
#include "suite.h"
#include "tiers.h"

/* Lengths of any size: what a power of two does to the arguments it does to the result, exactly. */
TEST(test_any_size)
{
    static const int powers[] = {-600, -300, 300, 600, 1000};
    for (uint64_t i = 0; i < 1000; i++) {
        int k = powers[i % 5], j = powers[i / 5 % 5];
        sure_vec3 v = suite_doubles(21, i, 2), n = suite_doubles(24, i, 2);
        sure_vec3 p = suite_doubles(27, i, 2);
        ck_vector_same(sure_project_stable(times_two_to(v, k), times_two_to(n, j)),
                       times_two_to(sure_project_stable(v, n), k));
        ck_vector_same(sure_reflect_stable(times_two_to(v, k), times_two_to(n, j)),
                       times_two_to(sure_reflect_stable(v, n), k));
        ck_double_same(
            sure_light_intensity_stable(times_two_to(p, k), times_two_to(n, j), times_two_to(v, k)),
            sure_light_intensity_stable(p, n, v));
    }
}

SUITE("stable")
