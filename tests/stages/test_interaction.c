/* SPDX-License-Identifier: MIT */
/* What double-doubles tell of a hit's point is what exact numbers tell, in every regime. Of what is
 * seen from afar, whose t may be known badly, they tell both: exact numbers take many times as
 * long. */
#include "every_case.h"
#include "rng.h"
#include "surroundings.h"

#include "../../src/cases/regimes/regimes_layout.h"
#include "../../src/geometry/coordinate.h"
#include "../../src/stages/hits/beyond.h"
#include "../../src/stages/rows.h"

#include <string.h>

enum { CASES = 60, SEED = 32, VIEWS = 200, AFAR = 36 };

/* True where it is told, and right. */
static bool tells_point(const sure_case *c, const sure_hit *hit)
{
    const shape_row *row = row_of(&c->object);
    sure_vec3 point, right = rounded_point(&c->ray, row, &c->object.as);
    bool tells = interaction_point(row, &c->ray, &c->object.as, hit, &point);
    ck_assert_msg(!tells || memcmp(&point, &right, sizeof point) == 0, "%s", case_text(c));
    return tells;
}

static bool tells_normal(const sure_case *c, const sure_hit *hit)
{
    const shape_row *row = row_of(&c->object);
    sure_vec3 normal, right = rounded_normal(&c->ray, row, &c->object.as);
    bool tells = interaction_normal(row, &c->ray, &c->object.as, hit, true, &normal);
    ck_assert_msg(!tells || memcmp(&normal, &right, sizeof normal) == 0, "%s", case_text(c));
    return tells;
}

LOOP_TEST(test_points, SURE_SHAPES)
{
    int told = 0;
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);) {
        for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
            sure_hit hit;
            if (sure_object_hit(&w.asked.ray, &w.asked.object, tier, &hit) == SURE_HIT)
                told += tells_point(&w.asked, &hit);
        }
    }
    ck_assert_int_gt(told, CASES);
}

/* Each holds the ball of radius 1/8 about 0. */
static const sure_object seen[] = {
    {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 1}}},
    {SURE_SHAPE_CYLINDER, {.cylinder = {{-0.75, -0.5, -1}, {0.75, 0.5, 1}, 0.5}}},
    {SURE_SHAPE_CONE, {.cone = {{-0.75, -0.5, -1}, {0.75, 0.5, 1}, 0.75}}},
};
enum { SEEN = sizeof seen / sizeof *seen };

/* To a point of that ball, from 2^k away, in any direction. */
static sure_case view_of(const sure_object *object, int k, rng *g)
{
    const sure_vec3 to = scaled(0x1p-3, rng_unit(g)), away = rng_unit(g);
    const sure_vec3 from = sum_of(to, power_of_two(k), away), d = scaled(-1, away);
    return (sure_case){.ray = {from, d, 0, INFINITY}, .object = *object};
}

LOOP_TEST(test_from_afar, SEEN)
{
    rng g = rng_of(SEED, (uint64_t)_i, 0, 0);
    for (int n = 0; n < VIEWS * (AFAR + 1); n++) {
        const int k = n / VIEWS;
        const sure_case c = view_of(&seen[_i], k, &g);
        sure_hit hit;
        ck_assert(sure_object_hit(&c.ray, &c.object, SURE_TIER_CERTAIN, &hit) == SURE_HIT);
        bool point = tells_point(&c, &hit), normal = tells_normal(&c, &hit);
        ck_assert_msg(normal && point, "2^%d away: %s", k, case_text(&c));
    }
}

/* May not be moved across a change of the environment. */
static sure_vec3 (*volatile normal_of)(const sure_ray *, const sure_cylinder *,
                                       const sure_hit *) = sure_cylinder_normal_exact;

/* An axis that leaves a coordinate's by next to nothing is not along it, flushed or not: the normal
 * is at right angles to the axis, so its component along that one is -2^-1074. */
LOOP_TEST(test_nearly_level, 6)
{
    const int along = _i / 2, aside = (along + 1 + _i % 2) % 3;
    double from[3] = {0}, d[3] = {0}, top[3] = {0}, right[3] = {0};
    sure_ray ray = {.t_max = INFINITY};
    sure_cylinder asked = {.radius = 1};
    from[along] = 4;
    from[aside] = 2;
    d[aside] = -1;
    top[along] = 8;
    top[aside] = 0x1p-1071;
    right[along] = -0x1p-1074;
    right[aside] = 1;
    memcpy(&ray.origin, from, sizeof from);
    memcpy(&ray.direction, d, sizeof d);
    memcpy(&asked.top, top, sizeof top);
    for (int e = 0; e < ENVIRONMENTS; e++) {
        sure_hit hit;
        surroundings_set(e);
        sure_status status = sure_cylinder_hit_exact(&ray, &asked, &hit);
        sure_vec3 normal = normal_of(&ray, &asked, &hit);
        surroundings_set(0);
        ck_assert(status == SURE_HIT && hit.part == SURE_PART_WALL);
        ck_assert_msg(memcmp(&normal, right, sizeof right) == 0, "%s", surroundings_name(e));
    }
}

SUITE("interaction")
