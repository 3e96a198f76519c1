/* Spawned origins against the oracles: on the right side, next to the true hit point, and missing
 * only where the whole box of neighbours is on the other side. */
#include "../support/suite.h"

#include "../../reference/bisection.h"
#include "../../reference/reference.h"
#include "regimes.h"
#include "../support/spawn_truth.h"
#include "../support/test_shape.h"
#include "../support/surroundings.h"
#include "../support/true_hit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Hits of a regime that are spawned from, those of them that the oracles prove, and of the others
 * those whose box is searched. */
enum { SEED = 8, HITS = 400, PROVED = 40, SEARCHED = 10, SIDES = 2 };

static const sure_vec3 untouched = {0x1.5p500, -0x1.5p500, 0x1.7p500};

static bool same_vector(sure_vec3 v, sure_vec3 w)
{
    return memcmp(&v, &w, sizeof v) == 0;
}

static const char *text(const sure_case *q, sure_side side)
{
    static char line[CASE_LINE_MAX + 16];
    case_print(q, line);
    strcat(line, side == SURE_SIDE_INSIDE ? ", inside" : ", outside");
    return line;
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
    if (sum->searched[side] >= SEARCHED)
        return;
    sum->searched[side]++;
    ck_assert_msg(!spawn_box_has(&object, p, side), "none, but there is: %s", text(q, side));
}

static void spawn_both(const sure_case *q, const sure_hit *hit, tally *sum)
{
    double p[3], t, true_t;
    bool asked = false;
    for (int side = 0; side < SIDES; side++) {
        sure_vec3 origin = untouched;
        int found = sure_spawn(&q->ray, &q->object, hit, (sure_side)side, &origin);
        sum->none[side] += found == 0;
        ck_assert(found == 1 || (found == 0 && same_vector(origin, untouched)));
        bool prove = found ? sum->hits < PROVED : sum->searched[side] < SEARCHED;
        if (prove && !asked) {
            asked = true;
            ck_assert_int_eq(reference_hit(&q->ray, &q->object, &t, NULL, NULL), SURE_HIT);
            ck_assert_msg(true_point(q, &true_t, p) && true_t == t, "no true hit: %s",
                          text(q, side));
        }
        if (prove && found) {
            sum->proved[side]++;
            prove_found(q, (sure_side)side, origin);
            prove_near(q, (sure_side)side, origin, p);
        } else if (prove) {
            prove_none(q, (sure_side)side, p, sum);
        }
    }
    sum->hits++;
}

static void run_regime(sure_shape shape, regime which)
{
    tally sum = {0};
    for (uint64_t index = 0; sum.hits < HITS && index < 4 * HITS; index++) {
        sure_case q = regime_case(shape, which, SEED, index);
        sure_hit hit;
        sure_tier tier = index % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
        if (sure_object_hit(&q.ray, &q.object, tier, &hit) == SURE_HIT)
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

typedef struct {
    int found[SIDES];
    sure_vec3 origin[SIDES];
} spawned;

static spawned spawn_in(const sure_case *q, const sure_hit *hit, int environment)
{
    spawned s = {.origin = {untouched, untouched}};
    surroundings_set(environment);
    for (int side = 0; side < SIDES; side++)
        s.found[side] = sure_spawn(&q->ray, &q->object, hit, (sure_side)side, &s.origin[side]);
    surroundings_set(0);
    return s;
}

static bool same_spawned(const spawned *a, const spawned *b)
{
    return a->found[0] == b->found[0] && a->found[1] == b->found[1] &&
           same_vector(a->origin[0], b->origin[0]) && same_vector(a->origin[1], b->origin[1]);
}

/* The same bits in every environment, from a hit of any. */
static void check_environments(const sure_case *q)
{
    sure_hit hit, other;
    if (sure_object_hit(&q->ray, &q->object, SURE_TIER_CERTAIN, &hit) != SURE_HIT)
        return;
    spawned expected = spawn_in(q, &hit, 0);
    for (int environment = 1; environment < SURROUNDINGS; environment++) {
        surroundings_set(environment);
        sure_tier tier = environment % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
        sure_status status = sure_object_hit(&q->ray, &q->object, tier, &other);
        surroundings_set(0);
        ck_assert_int_eq(status, SURE_HIT);
        spawned same_hit = spawn_in(q, &hit, environment);
        spawned own_hit = spawn_in(q, &other, environment);
        ck_assert_msg(same_spawned(&same_hit, &expected), "in %d: %s", environment, text(q, 0));
        ck_assert_msg(same_spawned(&own_hit, &expected), "by %d: %s", environment, text(q, 0));
    }
}

LOOP_TEST(test_environments, SURE_SHAPES)
{
    for (int which = 0; which < REGIMES; which++) {
        for (uint64_t index = 0; regime_applies((sure_shape)_i, (regime)which) && index < 60;
             index++) {
            sure_case q = regime_case((sure_shape)_i, (regime)which, SEED + 1, index);
            check_environments(&q);
        }
    }
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
    const sure_case q = {{{0, 0, 0}, {0, 0, 1}, 0, INFINITY}, objects[_i]};
    sure_hit hit;
    sure_vec3 origin = untouched;
    ck_assert_int_eq(sure_object_hit(&q.ray, &q.object, SURE_TIER_CERTAIN, &hit), SURE_HIT);
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_INSIDE, &origin), 0);
    ck_assert(same_vector(origin, untouched));
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_OUTSIDE, &origin), 1);
    prove_found(&q, SURE_SIDE_OUTSIDE, origin);
}

/* The floor y = 0: next to it are the least subnormals, and the other coordinates stay. */
TEST(test_floor)
{
    const sure_case q = {{{0.1, 10, 0.3}, {0.3, -1, 0.7}, 0, INFINITY},
                         {.shape = SURE_SHAPE_PLANE, .as.plane = {{1, 0, 2}, {0, 3, 0}}}};
    sure_hit hit;
    sure_vec3 above, below;
    ck_assert_int_eq(sure_object_hit(&q.ray, &q.object, SURE_TIER_CERTAIN, &hit), SURE_HIT);
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_OUTSIDE, &above), 1);
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_INSIDE, &below), 1);
    ck_vector_same(above, (sure_vec3){above.x, 0x1p-1074, above.z});
    ck_vector_same(below, (sure_vec3){above.x, -0x1p-1074, above.z});
}

/* Beyond the greatest double is nothing. */
TEST(test_greatest)
{
    const double most = 0x1.fffffffffffffp1023;
    const sure_case q = {{{0, 1, 2}, {1, 0, 0}, 0, INFINITY},
                         {.shape = SURE_SHAPE_PLANE, .as.plane = {{most, 0, 0}, {1, 0, 0}}}};
    sure_hit hit;
    sure_vec3 origin = untouched;
    ck_assert_int_eq(sure_object_hit(&q.ray, &q.object, SURE_TIER_EXACT, &hit), SURE_HIT);
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_OUTSIDE, &origin), 0);
    ck_assert(same_vector(origin, untouched));
    ck_assert_int_eq(sure_spawn(&q.ray, &q.object, &hit, SURE_SIDE_INSIDE, &origin), 1);
    ck_vector_same(origin, (sure_vec3){0x1.ffffffffffffep1023, 1, 2});
}

SUITE("spawn")
