#include "suite.h"

#include <math.h>

static sure_vec3 (*const reflect[PLAIN_TIERS])(sure_vec3, sure_vec3) = {
    sure_reflect_float32, sure_reflect_textbook, sure_reflect_stable};

/* Squared lengths 1, 2, 4, 16. */
static const sure_vec3 normals[] = {{0, 1, 0}, {1, 0, -1}, {-2, 0, 0}, {1, 1, 0}, {0, 0, 4}};
enum { NORMALS = sizeof normals / sizeof *normals };

static sure_vec3 small(uint64_t index)
{
    return (sure_vec3){suite_integer(1, index, 99), suite_integer(2, index, 99),
                       suite_integer(3, index, 99)};
}

static double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static sure_vec3 times(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

START_TEST(test_known)
{
    ck_vector_same(reflect[_i]((sure_vec3){1, 1, 0}, (sure_vec3){0, 1, 0}), (sure_vec3){-1, 1, 0});
    ck_vector_same(reflect[_i]((sure_vec3){3, 1, -2}, (sure_vec3){1, 1, 0}), (sure_vec3){1, 3, 2});
}
END_TEST

START_TEST(test_law_1)
{
    for (int i = 0; i < NORMALS; i++) {
        sure_vec3 n = normals[i], across = {n.y - n.z, n.z - n.x, n.x - n.y};
        ck_vector_same(reflect[_i](times(7, n), n), times(7, n));
        ck_vector_same(reflect[_i](across, n), times(-1, across));
    }
}
END_TEST

START_TEST(test_law_2)
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
END_TEST

START_TEST(test_law_3)
{
    for (uint64_t i = 0; i < 1000; i++) {
        sure_vec3 v = small(i), n = normals[i % NORMALS];
        sure_vec3 mirrored = reflect[_i](v, n);
        ck_vector_same(reflect[_i](mirrored, n), v);
        ck_double_same(dot(mirrored, n), dot(v, n));
        ck_double_same(dot(mirrored, mirrored), dot(v, v));
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("reflect");
    suite_add_tiers(suite, "known", test_known);
    suite_add_tiers(suite, "law 1", test_law_1);
    suite_add_tiers(suite, "law 2", test_law_2);
    suite_add_tiers(suite, "law 3", test_law_3);
    return suite_run(suite);
}
