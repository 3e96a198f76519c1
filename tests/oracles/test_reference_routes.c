/* SPDX-License-Identifier: MIT */
/* The reference against other routes to the truth: CGAL's kernels, the definition at exact points,
 * the hard cases. The laws that every oracle keeps are in test_oracle_laws.c. */
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "every_case.h"
#include "oracle.h"
#include "reference.h"
#include "surroundings.h"

enum { SEED = 20, CASES = 60 };

/* The chord passes its proof; shapes that CGAL has a kernel for get the same one from it. */
static void other_routes_agree(const sure_case *q)
{
    sure_interval chord = {0, 0, SURE_PART_SURFACE, SURE_PART_SURFACE}, by_kernel = chord;
    sure_status status = reference_interval(&q->ray, &q->object, &chord);
    sure_status hit = reference_hit(&q->ray, &q->object, NULL, NULL, NULL);
    ck_assert_int_eq(reference_occluded(&q->ray, &q->object), hit);
    ck_assert_int_eq(hit == SURE_INVALID, status == SURE_INVALID);
    if (status == SURE_INVALID)
        return;
    ck_assert_msg(reference_certify(&q->ray, &q->object), "not proved: %s", case_text(q));
    if (reference_has_kernel(q->object.shape)) {
        ck_assert_msg(reference_kernel_interval(&q->ray, &q->object, &by_kernel) == status &&
                          memcmp(&by_kernel.t_enter, &chord.t_enter, 2 * sizeof(double)) == 0,
                      "CGAL's kernel differs: %s", case_text(q));
    }
}

LOOP_TEST(test_other_routes, SURE_SHAPES)
{
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);)
        other_routes_agree(&w.asked);
}

static int sign_of_hit_minus(const sure_case *q, double x)
{
    int sign = 77;
    reference_compare_hit(&q->ray, &q->object, x, &sign);
    return sign;
}

static sure_status hit_between(const sure_case *q, double t_min, double t_max)
{
    sure_ray ray = q->ray;
    ray.t_min = t_min;
    ray.t_max = t_max;
    return reference_hit(&ray, &q->object, NULL, NULL, NULL);
}

/* The distance of the real t* from its double is at most half a step to the next one. */
static void half_a_step_holds(const sure_case *q)
{
    double t;
    int within = 77;
    if (reference_hit(&q->ray, &q->object, &t, NULL, NULL) != SURE_HIT || t == INFINITY)
        return;
    double half_step = ldexp(nextafter(t, INFINITY) - t, -1);
    reference_hit_within(&q->ray, &q->object, t, half_step, &within);
    ck_assert_int_eq(within, half_step > 0 || sign_of_hit_minus(q, t) == 0);
}

LOOP_TEST(test_half_a_step, SURE_SHAPES)
{
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);)
        half_a_step_holds(&w.asked);
}

static int applied;

/* In a world of small integers every ray is walked in eighths: at each of these points a ray of
 * that one point must hit exactly where CGAL's kernel sees the boundary, have its chord exactly
 * where it sees the object, and nothing of the boundary comes before the hit. */
static void walk(const sure_case *q)
{
    sure_case stand = *q;
    sure_status hit = reference_hit(&q->ray, &q->object, NULL, NULL, NULL);
    if (hit == SURE_INVALID)
        return;
    for (int step = 0; step <= 40; step++) {
        double t = step / 8.0;
        int side = reference_where_at(&q->ray, &q->object, t);
        bool outside = sure_shape_info_of(q->object.shape)->solid ? side > 0 : side != 0;
        stand.ray.t_min = stand.ray.t_max = t;
        ck_assert_msg((hit_between(q, t, t) == SURE_HIT) == (side == 0), "at %a: %s", t,
                      case_text(q));
        ck_assert_msg((reference_interval(&stand.ray, &q->object, NULL) == SURE_HIT) == !outside,
                      "at %a: %s", t, case_text(q));
        if (side == 0 && t >= q->ray.t_min && t <= q->ray.t_max) {
            ck_assert_int_eq(hit, SURE_HIT);
            ck_assert_int_le(sign_of_hit_minus(q, t), 0);
        }
    }
    applied += hit == SURE_HIT;
}

LOOP_TEST(test_walks, SURE_SHAPES)
{
    uint64_t count = regime_integers_count((sure_shape)_i), taken = 600;
    applied = 0;
    for (uint64_t i = 0; i < taken; i++) {
        uint64_t index = i * (count / taken) + i;
        sure_case question = regime_case((sure_shape)_i, REGIME_INTEGERS, SEED, index);
        walk(&question);
    }
    ck_assert_int_gt(applied, 60);
}

static unsigned control_register(void)
{
#if defined(__SSE2__)
    return _mm_getcsr();
#else
    return (unsigned)fegetround();
#endif
}

/* Everything that can be asked of a case, and two angles. */
typedef struct {
    bisection_result answer;
    sure_interval by_kernel;
    sure_vec3 rotated;
    double extent;
    bool proved;
} everything;

static everything all_of(const sure_case *q)
{
    everything all = {.answer = oracles[1].answer(q)};
    if (reference_has_kernel(q->object.shape))
        reference_kernel_interval(&q->ray, &q->object, &all.by_kernel);
    all.rotated = reference_rotate(2, 1, (sure_vec3){1, 0x1p-1074, 0});
    all.extent = reference_viewport_extent(1, 60);
    all.proved = all.answer.status == SURE_INVALID || reference_certify(&q->ray, &q->object);
    return all;
}

/* Answers, and the environment itself, are the same in every rounding mode and when the
 * processor takes subnormals for zeros. */
static void environment_does_not_matter(const sure_case *q)
{
    static const int numbers[] = {4, 1, 6, 3};
    everything expected = all_of(q);
    for (int i = 0; i < 4; i++) {
        surroundings_set(numbers[i] % SURROUNDINGS);
        unsigned before = control_register();
        everything is = all_of(q);
        unsigned after = control_register();
        surroundings_set(0);
        ck_assert_uint_eq(after, before);
        ck_assert_msg(bisection_same(&is.answer, &expected.answer) &&
                          memcmp(&is.by_kernel, &expected.by_kernel, sizeof is.by_kernel) == 0 &&
                          is.proved,
                      "rounding %s: %s", surroundings_name(numbers[i]), case_text(q));
        ck_vector_same(is.rotated, expected.rotated);
        ck_double_same(is.extent, expected.extent);
    }
}

LOOP_TEST(test_environment, SURE_SHAPES)
{
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES / 6); walk_next(&w);)
        environment_does_not_matter(&w.asked);
}

SUITE("reference routes")
