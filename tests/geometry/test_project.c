/* SPDX-License-Identifier: MIT */
/* Laws 1 and 3 follow from the true projections of tests/oracles/part_check.c. */
#include "suite.h"
#include "objects.h"

#include <signal.h>

static sure_vec3 (*const project[PLAIN_TIERS])(sure_vec3, sure_vec3) = OF_PLAIN_TIERS(sure_project);

static sure_vec3 small(uint64_t index)
{
    return suite_integers(1, index, 9);
}

LOOP_TEST(test_known, PLAIN_TIERS)
{
    ck_vector_same(project[_i]((sure_vec3){1, 1, 0}, (sure_vec3){0, 3, 0}), (sure_vec3){0, 1, 0});
    ck_vector_same(project[_i]((sure_vec3){5, 0, 7}, (sure_vec3){1, 1, 0}),
                   (sure_vec3){2.5, 2.5, 0});
    ck_vector_same(project[_i]((sure_vec3){1, 2, 1}, (sure_vec3){-2, 2, 0}),
                   (sure_vec3){-0.5, 0.5, 0});
}

LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 1000; i++) {
        sure_vec3 v = small(i), n = small(i + 5000);
        if (dot(n, n) == 0)
            continue;
        sure_vec3 plain = project[_i](v, n);
        ck_vector_same(project[_i](v, times(ldexp(1, suite_integer(5, i, 20)), n)), plain);
        ck_vector_same(project[_i](v, times(-1, n)), plain);
        ck_vector_same(project[_i](times(8, v), n), times(8, plain));
    }
}

/* Also of components that are far less than V is long. */
TEST(test_small_components)
{
    const sure_vec3 v = {1, 0x1p-1000, 0};
    for (int k = -1000; k <= 1000; k += 50) {
        const sure_vec3 n = {0, ldexp(1, k), 0};
        ck_vector_same(sure_project_stable(v, n), (sure_vec3){0, 0x1p-1000, 0});
        ck_vector_same(sure_reflect_stable(v, n), (sure_vec3){-1, 0x1p-1000, 0});
    }
}

/* The squares of both are in range, but n.v / |n|^2 is not. */
SIGNAL_TEST(test_overflow, SIGABRT)
{
    (void)sure_project_textbook((sure_vec3){0x1p520, 0, 0}, (sure_vec3){0x1p-510, 0, 0});
}

SIGNAL_TEST(test_no_number, SIGABRT)
{
    (void)sure_reflect_textbook((sure_vec3){INFINITY, 0, 0}, (sure_vec3){1, 0, 0});
}

SUITE("project")
