/* SPDX-License-Identifier: MIT */
/* Laws 1 and 3 follow from the true reflections of tests/oracles/part_check.c. */
#include "suite.h"
#include "objects.h"

static sure_vec3 (*const reflect[PLAIN_TIERS])(sure_vec3, sure_vec3) = OF_PLAIN_TIERS(sure_reflect);

static sure_vec3 small(uint64_t index)
{
    return suite_integers(1, index, 99);
}

LOOP_TEST(test_known, PLAIN_TIERS)
{
    ck_vector_same(reflect[_i]((sure_vec3){1, 1, 0}, (sure_vec3){0, 1, 0}), (sure_vec3){-1, 1, 0});
    ck_vector_same(reflect[_i]((sure_vec3){3, 1, -2}, (sure_vec3){1, 1, 0}), (sure_vec3){1, 3, 2});
}

LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 1000; i++) {
        sure_vec3 v = small(i), n = small(i + 5000);
        if (dot(n, n) == 0)
            continue;
        sure_vec3 plain = reflect[_i](v, n);
        ck_vector_same(reflect[_i](v, times(ldexp(1, suite_integer(4, i, 20)), n)), plain);
        ck_vector_same(reflect[_i](v, times(-1, n)), plain);
    }
    if (_i == SURE_TIER_STABLE) { /* of the normal alone the square leaves the range */
        sure_vec3 n = times(0x1p700, (sure_vec3){1, 1, 0});
        ck_vector_same(reflect[_i]((sure_vec3){3, 1, -2}, n), (sure_vec3){1, 3, 2});
    }
}

SUITE("reflect")
