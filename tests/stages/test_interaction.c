/* SPDX-License-Identifier: MIT */
/* What double-doubles tell of a hit's point is what exact numbers tell, in every regime. Of what is
 * seen from afar, whose t may be known badly, they tell the normal, and the point as long as they
 * have the digits: exact numbers take many times as long. */
#include "every_case.h"
#include "rng.h"

#include "../../src/cases/regimes/regimes_layout.h"
#include "../../src/geometry/coordinate.h"
#include "../../src/stages/hits/beyond.h"
#include "../../src/stages/rows.h"

#include <string.h>

enum { CASES = 60, SEED = 32, VIEWS = 200, POINTS_TO = 20, NORMALS_TO = 36 };

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
    sure_vec3 normal;
    return interaction_normal(row_of(&c->object), &c->ray, &c->object.as, hit, false, &normal);
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
    for (int n = 0; n < VIEWS * (NORMALS_TO + 1); n++) {
        const int k = n / VIEWS;
        const sure_case c = view_of(&seen[_i], k, &g);
        sure_hit hit;
        ck_assert(sure_object_hit(&c.ray, &c.object, SURE_TIER_CERTAIN, &hit) == SURE_HIT);
        bool point = tells_point(&c, &hit), normal = tells_normal(&c, &hit);
        ck_assert_msg(normal && (point || k > POINTS_TO), "2^%d away: %s", k, case_text(&c));
    }
}

SUITE("interaction")
