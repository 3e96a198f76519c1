/* SPDX-License-Identifier: MIT */
/* Normals of certain against true ones: SURE_NORMAL_ERROR in every regime, in every rounding mode
 * and with subnormals flushed, for the hits that certain gives and for the worst it might have
 * given. */
#include "every_case.h"
#include "reference.h"
#include "surroundings.h"
#include "../../src/geometry/coordinate.h"

enum { CASES = 50, SEED = 30 };

typedef struct {
    sure_case asked;
    sure_hit truth;
    sure_vec3 normal;
    double worst; /* error over bound */
} trial;

/* Both may not be moved across a change of the environment. */
static sure_status (*volatile hit_of)(const sure_ray *, const sure_object *, sure_tier,
                                      sure_hit *) = sure_object_hit;
static sure_vec3 (*volatile normal_of)(const sure_ray *, const sure_object *, sure_tier,
                                       const sure_hit *) = sure_object_normal;

static void judge(trial *x, int environment, sure_vec3 normal)
{
    double off = fmax(fmax(fabs(normal.x - x->normal.x), fabs(normal.y - x->normal.y)),
                      fabs(normal.z - x->normal.z));
    int within = off <= SURE_NORMAL_ERROR - 0x1p-53; /* what a rounded component is off by */
    if (!within)
        reference_normal_within(&x->asked.ray, &x->asked.object, normal, SURE_NORMAL_ERROR,
                                &within);
    ck_assert_msg(within, "rounding %s, off by %a: %s", surroundings_name(environment), off,
                  case_text(&x->asked));
    x->worst = fmax(x->worst, off / SURE_NORMAL_ERROR);
}

static void ask(trial *x, int environment, const sure_hit *given)
{
    sure_hit hit;
    surroundings_set(environment);
    if (given)
        hit = *given;
    else
        hit_of(&x->asked.ray, &x->asked.object, SURE_TIER_CERTAIN, &hit);
    sure_vec3 normal = normal_of(&x->asked.ray, &x->asked.object, SURE_TIER_CERTAIN, &hit);
    surroundings_set(0);
    judge(x, environment, normal);
}

static void as_answered(trial *x)
{
    for (int e = 0; e < ENVIRONMENTS; e++)
        ask(x, e, NULL);
}

static bool find_truth(trial *x)
{
    return reference_hit(&x->asked.ray, &x->asked.object, &x->truth.t, &x->truth.part,
                         &x->normal) == SURE_HIT;
}

/* A t as far from the true one as its error says, less two roundings, of that one and of t. Errors
 * shrink until every stage takes them; the last is that of a rounded t. */
static void as_bad_as_may_be(trial *x)
{
    double t = x->truth.t;
    bool usual = t > 0x1p-900 && t < 0x1p900;
    for (int e = 0; e < ENVIRONMENTS && usual; e++)
        ask(x, e, &(sure_hit){t, ldexp(t, -53), x->truth.part, 0});
    for (int k = 10; k < 50 && usual; k++) {
        double error = ldexp(t, -k), most = (1 - 0x1p-8) * error - ldexp(t, -52);
        double off = k % 2 == 0 ? most : -most;
        sure_hit given = {t + off, error, x->truth.part, 0};
        ask(x, k % ENVIRONMENTS, &given);
        ask(x, (k + 2) % ENVIRONMENTS, &given);
    }
}

/* The same from nearby: t's error is then less than what rounds the point, which may be far from
 * the base, apex or centre. */
static void from_nearby(trial *x)
{
    sure_ray *ray = &x->asked.ray;
    double t = x->truth.t * (1 - 0x1p-20);
    for (int i = 0; i < 3; i++)
        *coordinate_of(&ray->origin, i) += t * coordinate(ray->direction, i);
    ray->t_min = 0;
    ray->t_max = INFINITY;
    if (find_truth(x))
        as_bad_as_may_be(x);
}

/* A bound that is met from afar only would be no bound of what is done: 1/64 of it is reached where
 * the surface is curved. */
static const struct {
    const char *name;
    void (*what)(trial *);
    double least;
} ways[] = {{"answered", as_answered, 0},
            {"from nearby", from_nearby, 0},
            {"t at its error", as_bad_as_may_be, 1.0 / 64}};

LOOP_TEST(test_normals, 3 * SURE_SHAPES)
{
    sure_shape shape = (sure_shape)(_i / 3);
    bool curved = sure_shape_info_of(shape)->solid && shape_has(shape, SURE_KIND_RADIUS);
    trial x = {.worst = 0};
    for (case_walk w = walk_regimes(shape, SEED, CASES); walk_next(&w);) {
        x.asked = w.asked;
        if (find_truth(&x))
            ways[_i % 3].what(&x);
    }
    printf("%s, %s: error/bound %.4g\n", sure_shape_name(shape), ways[_i % 3].name, x.worst);
    ck_assert(!curved || x.worst > ways[_i % 3].least);
}

SUITE("normals")
