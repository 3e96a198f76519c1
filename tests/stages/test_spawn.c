/* SPDX-License-Identifier: MIT */
/* Spawned origins against the oracles: on the right side, next to the true hit point, and missing
 * only where the whole box of neighbours is on the other side. */

#include "../../reference/bisection.h"
#include "../../reference/reference.h"
#include "../support/spawn_truth.h"
#include "spawned.h"

#include <signal.h>

/* Hits of a regime that are spawned from, those of them that the oracles prove, and of the others
 * those whose box is searched. */
enum { SEED = 8, HITS = 400, PROVED = 40, SEARCHED = 10 };

static uint64_t in_share(int count)
{
    static uint64_t share;
    share = share ? share : suite_setting("SUREHIT_SHARE", 1);
    return ((uint64_t)count + share - 1) / share;
}

/* By bisection: a ray of one point meets a closed solid, or not, and its boundary, or not; a plane
 * is met from the side that its normal points to by a ray against the normal. */
static bool is_on_side(const sure_object *object, sure_vec3 p, sure_side side)
{
    bisection_result result;
    sure_ray ray = {p, {1, 2, 3}, 0, 0};
    sure_status on_boundary = bisection_answer(&ray, object, &result);
    if (sure_shape_info_of(object->shape)->solid) {
        bool within = result.interval_status == SURE_HIT;
        return on_boundary == SURE_MISS && within == (side == SURE_SIDE_INSIDE);
    }
    sure_vec3 n = object->as.plane.normal;
    double sign = side == SURE_SIDE_OUTSIDE ? -1 : 1;
    ray.direction = (sure_vec3){sign * n.x, sign * n.y, sign * n.z};
    ray.t_max = INFINITY;
    return on_boundary == SURE_MISS && bisection_answer(&ray, object, &result) == SURE_HIT;
}

typedef struct {
    unsigned hits, none[SIDES], proved[SIDES], searched[SIDES];
} tally;

static void prove_found(const sure_case *q, sure_side side, sure_vec3 origin)
{
    sure_object object = object_sided(&q->object);
    ck_assert_msg(spawn_is_on_side(&object, origin, side), "wrong side: %s", text(q, side));
    ck_assert_msg(is_on_side(&object, origin, side), "wrong side by bisection: %s", text(q, side));
}

static void prove_near(const sure_case *q, sure_side side, sure_vec3 origin, const double p[3])
{
    const double x[3] = {origin.x, origin.y, origin.z};
    for (int i = 0; i < 3; i++)
        ck_assert_msg(reference_ulps(x[i], p[i]) <= SURE_SPAWN_STEPS, "%d: %a far from %a: %s", i,
                      x[i], p[i], text(q, side));
}

static void prove_none(const sure_case *q, sure_side side, const double p[3], tally *sum)
{
    sure_object object = object_sided(&q->object);
    ck_assert_msg(spawn_may_have_none(&q->object, p, side), "none: %s", text(q, side));
    if (sum->searched[side] >= in_share(SEARCHED))
        return;
    sum->searched[side]++;
    ck_assert_msg(!spawn_box_has(&object, p, side), "none, but there is: %s", text(q, side));
}

static void spawn_both(const sure_case *q, const sure_hit *hit, tally *sum)
{
    double p[3], t, true_t;
    bool asked = false;
    for (int side = 0; side < SIDES; side++) {
        const spawned s = spawn_in(q, hit, side, 0), none = {0, untouched};
        sum->none[side] += s.found == 0;
        ck_assert(s.found == 1 || same_spawned(&s, &none));
        bool prove =
            s.found ? sum->hits < in_share(PROVED) : sum->searched[side] < in_share(SEARCHED);
        if (prove && !asked) {
            asked = true;
            ck_assert_int_eq(reference_hit(&q->ray, &q->object, &t, NULL, NULL), SURE_HIT);
            ck_assert_msg(true_point(q, &true_t, p) && true_t == t, "no true hit: %s",
                          text(q, side));
        }
        if (prove && s.found) {
            sum->proved[side]++;
            prove_found(q, (sure_side)side, s.origin);
            prove_near(q, (sure_side)side, s.origin, p);
        } else if (prove) {
            prove_none(q, (sure_side)side, p, sum);
        }
    }
    sum->hits++;
}

static void run_regime(sure_shape shape, regime which)
{
    tally sum = {0};
    for (uint64_t index = 0; sum.hits < in_share(HITS) && index < 4 * in_share(HITS); index++) {
        sure_case q = regime_case(shape, which, SEED, index);
        sure_hit hit;
        if (hit_of(&q, index, &hit))
            spawn_both(&q, &hit, &sum);
    }
    ck_assert_uint_gt(sum.hits, 0);
    printf(
        "%-9s %-14s %5u hits, none outside %6.2f %%, inside %6.2f %%; proved %u, searched %u %u\n",
        sure_shape_name(shape), regime_name(which), sum.hits, 100.0 * sum.none[0] / sum.hits,
        100.0 * sum.none[1] / sum.hits, sum.proved[0] + sum.proved[1], sum.searched[0],
        sum.searched[1]);
    if (which == REGIME_TYPICAL)
        ck_assert_uint_eq(sum.none[0] + sum.none[1], 0);
}

/* Laws 1 and 2. */
LOOP_TEST(test_regimes, SURE_SHAPES *REGIMES)
{
    sure_shape shape = (sure_shape)(_i / REGIMES);
    regime which = (regime)(_i % REGIMES);
    if (regime_applies(shape, which))
        run_regime(shape, which);
    fflush(stdout);
}

/* The same bits in every environment, from a hit of any. */
LOOP_TEST(test_environments, SURE_SHAPES)
{
    for (case_walk w = walk_regimes((sure_shape)_i, SEED + 1, 60); walk_next(&w);) {
        sure_hit hit, other;
        for (int k = 0; k < SIDES * SURROUNDINGS && hit_of(&w.asked, 0, &hit); k++) {
            int side = k % SIDES, environment = k / SIDES;
            spawned expected = spawn_in(&w.asked, &hit, side, 0);
            surroundings_set(environment);
            bool hits = hit_of(&w.asked, (uint64_t)environment, &other);
            surroundings_set(0);
            spawned same_hit = spawn_in(&w.asked, &hit, side, environment);
            spawned own_hit = spawn_in(&w.asked, &other, side, environment);
            ck_assert_msg(hits && same_spawned(&same_hit, &expected) &&
                              same_spawned(&own_hit, &expected),
                          "in %d: %s", environment, text(&w.asked, side));
        }
    }
}

static void expect_spawned(const sure_case *q, sure_side side, int found, spawned *s)
{
    const spawned none = {0, untouched};
    sure_hit hit;
    ck_assert(hit_of(q, 1, &hit));
    *s = spawn_in(q, &hit, (int)side, 0);
    ck_assert_msg(s->found == found && (found || same_spawned(s, &none)), "%s", text(q, (int)side));
}

/* A point and a segment have an outside and no inside. */
LOOP_TEST(test_radius_zero, 3)
{
    const sure_vec3 low = {0, 0, 4}, high = {0, 3, 4};
    const sure_object objects[] = {
        {.shape = SURE_SHAPE_SPHERE, .as.sphere = {low, 0}},
        {.shape = SURE_SHAPE_CYLINDER, .as.cylinder = {low, high, 0}},
        {.shape = SURE_SHAPE_CONE, .as.cone = {low, high, 0}},
    };
    const sure_case q = {.ray = {{0, 0, 0}, {0, 0, 1}, 0, INFINITY}, .object = objects[_i]};
    spawned s;
    expect_spawned(&q, SURE_SIDE_INSIDE, 0, &s);
    expect_spawned(&q, SURE_SIDE_OUTSIDE, 1, &s);
    prove_found(&q, SURE_SIDE_OUTSIDE, s.origin);
}

/* The floor y = 0: next to it are the least subnormals, and the other coordinates stay. */
TEST(test_floor)
{
    const sure_case q = {.ray = {{0.1, 10, 0.3}, {0.3, -1, 0.7}, 0, INFINITY},
                         .object = {.shape = SURE_SHAPE_PLANE, .as.plane = {{1, 0, 2}, {0, 3, 0}}}};
    spawned above, below;
    expect_spawned(&q, SURE_SIDE_OUTSIDE, 1, &above);
    expect_spawned(&q, SURE_SIDE_INSIDE, 1, &below);
    ck_vector_same(above.origin, (sure_vec3){above.origin.x, 0x1p-1074, above.origin.z});
    ck_vector_same(below.origin, (sure_vec3){above.origin.x, -0x1p-1074, above.origin.z});
}

/* Beyond the greatest double is nothing. */
TEST(test_greatest)
{
    const double most = 0x1.fffffffffffffp1023;
    const sure_case q = {
        .ray = {{0, 1, 2}, {1, 0, 0}, 0, INFINITY},
        .object = {.shape = SURE_SHAPE_PLANE, .as.plane = {{most, 0, 0}, {1, 0, 0}}}};
    spawned s;
    expect_spawned(&q, SURE_SIDE_OUTSIDE, 0, &s);
    expect_spawned(&q, SURE_SIDE_INSIDE, 1, &s);
    ck_vector_same(s.origin, (sure_vec3){0x1.ffffffffffffep1023, 1, 2});
}

/* What a ray does not hit is no question. */
SIGNAL_TEST(test_not_hit, SIGABRT)
{
    const sure_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const sure_object beside = {.shape = SURE_SHAPE_PLANE, .as.plane = {{0, 0, 1}, {0, 0, 1}}};
    const sure_hit made_up = {1, 0, SURE_PART_SURFACE, 0};
    sure_vec3 origin;
    sure_spawn(&ray, &beside, &made_up, SURE_SIDE_OUTSIDE, &origin);
}

SUITE("spawn")
