/* SPDX-License-Identifier: MIT */
/* The notes' parts against the reference, over every regime: heights, walls, their normals, end
 * points, projection and reflection. */
#include "every_case.h"
#include "hard_points.h"
#include "part_check.h"

static part_unrounded unrounded;

static void require(const sure_case *c, const char *broken)
{
    case_require(c, !broken, broken ? broken : "");
}

/* Of the ray's numbers an axis, a centre and a height are made, too. */
static void check_case(const sure_case *c, uint64_t draw)
{
    const sure_object *solid = &c->object;
    sure_vec3 centre = c->ray.origin, axis = c->ray.direction;
    double height = ldexp((double)(draw % 512), (int)(draw >> 32 & 7) - 3);
    require(c, wall_hit_broken(&c->ray, solid, &unrounded));
    require(c, end_points_broken(solid->shape, centre, axis, solid->as.cylinder.radius, height,
                                 &unrounded));
    if (!case_is_valid(c))
        return;
    sure_vec3 p = hard_point(solid, draw), v = solid->as.cylinder.top;
    require(c, height_broken(solid, p, &unrounded));
    require(c, wall_normal_broken(solid, p, &unrounded));
    require(c, vectors_broken(v, axis, &unrounded));
    require(c, vectors_broken(axis, axis, &unrounded));
}

SHAPE_TEST(test_parts)
{
    const uint64_t count = 20000 / suite_setting("SUREHIT_SHARE", 10);
    if (!has_parts(_i))
        return;
    unrounded = (part_unrounded){0};
    for (case_walk w = walk_regimes(_i, 5, count); walk_next(&w);)
        check_case(&w.asked, suite_bits(1, w.index));
    ck_assert_uint_gt(unrounded.heights, count / 10);
    ck_assert_uint_gt(unrounded.walls, count / 10);
    ck_assert_uint_gt(unrounded.others, count / 10);
}

/* Hits by sign changes, of every shape. */
SHAPE_TEST(test_brackets)
{
    const uint64_t count = 1000 / suite_setting("SUREHIT_SHARE", 10);
    unsigned long asked = 0;
    for (case_walk w = walk_regimes(_i, 6, count); walk_next(&w);) {
        if (case_is_valid(&w.asked))
            require(&w.asked, bracket_broken(&w.asked.ray, &w.asked.object, &asked));
    }
    ck_assert_msg(asked > count || _i == SURE_SHAPE_DISC, "only %lu are asked", asked);
}

SUITE("parts")
