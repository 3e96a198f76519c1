#include "suite.h"
#include "objects.h"

#include <math.h>

static sure_vec3 (*const reflect[PLAIN_TIERS])(sure_vec3, sure_vec3) = OF_PLAIN_TIERS(sure_reflect);

/* Squared lengths 1, 2, 4, 16. */
static const sure_vec3 normals[] = {{0, 1, 0}, {1, 0, -1}, {-2, 0, 0}, {1, 1, 0}, {0, 0, 4}};
enum { NORMALS = sizeof normals / sizeof *normals };

static sure_vec3 small(uint64_t index)
{
    return suite_integers(1, index, 99);
}

LOOP_TEST(test_known, PLAIN_TIERS)
{
    ck_vector_same(reflect[_i]((sure_vec3){1, 1, 0}, (sure_vec3){0, 1, 0}), (sure_vec3){-1, 1, 0});
    ck_vector_same(reflect[_i]((sure_vec3){3, 1, -2}, (sure_vec3){1, 1, 0}), (sure_vec3){1, 3, 2});
}

LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    for (int i = 0; i < NORMALS; i++) {
        sure_vec3 n = normals[i], across = {n.y - n.z, n.z - n.x, n.x - n.y};
        ck_vector_same(reflect[_i](times(7, n), n), times(7, n));
        ck_vector_same(reflect[_i](across, n), times(-1, across));
    }
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

LOOP_TEST(test_law_3, PLAIN_TIERS)
{
    for (uint64_t i = 0; i < 1000; i++) {
        sure_vec3 v = small(i), n = normals[i % NORMALS];
        sure_vec3 mirrored = reflect[_i](v, n);
        ck_vector_same(reflect[_i](mirrored, n), v);
        ck_double_same(dot(mirrored, n), dot(v, n));
        ck_double_same(dot(mirrored, mirrored), dot(v, v));
    }
}

SUITE("reflect")
