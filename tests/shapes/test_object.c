/* SPDX-License-Identifier: MIT */
#include "every_case.h"

/* The object's functions are the shape's own: the same bits, tier by tier. */
#define SAME_AS_OWN(shape, tier)                                                                   \
    do {                                                                                           \
        sure_hit own = {0}, any = {0};                                                             \
        sure_interval own_chord = {0}, any_chord = {0};                                            \
        const sure_ray *ray = &question.ray;                                                       \
        const sure_object *object = &question.object;                                              \
        sure_tier t;                                                                               \
        ck_assert(sure_tier_from_name(#tier, &t));                                                 \
        ck_assert_int_eq(sure_object_check(ray, object),                                           \
                         sure_##shape##_check(ray, &object->as.shape));                            \
        ck_assert_int_eq(sure_object_hit(ray, object, t, &any),                                    \
                         sure_##shape##_hit_##tier(ray, &object->as.shape, &own));                 \
        ck_assert(memcmp(&any, &own, sizeof own) == 0);                                            \
        ck_assert_int_eq(sure_object_interval(ray, object, t, &any_chord),                         \
                         sure_##shape##_interval_##tier(ray, &object->as.shape, &own_chord));      \
        ck_assert(memcmp(&any_chord, &own_chord, sizeof own_chord) == 0);                          \
        ck_assert_int_eq(sure_object_occluded(ray, object, t),                                     \
                         sure_##shape##_occluded_##tier(ray, &object->as.shape));                  \
        if (sure_object_hit(ray, object, t, &any) != SURE_HIT)                                     \
            break;                                                                                 \
        sure_vec3 a = sure_object_normal(ray, object, t, &any);                                    \
        sure_vec3 b = sure_##shape##_normal_##tier(ray, &object->as.shape, &own);                  \
        ck_assert(memcmp(&a, &b, sizeof a) == 0);                                                  \
    } while (0)

#define OWN_TEST(shape, SHAPE)                                                                     \
    TEST(test_##shape)                                                                             \
    {                                                                                              \
        for (uint64_t i = 0; i < 500; i++) {                                                       \
            sure_case question = regime_case(SURE_SHAPE_##SHAPE, REGIME_TYPICAL, 1, i);            \
            SAME_AS_OWN(shape, float32);                                                           \
            SAME_AS_OWN(shape, textbook);                                                          \
            SAME_AS_OWN(shape, stable);                                                            \
            SAME_AS_OWN(shape, certain);                                                           \
            SAME_AS_OWN(shape, exact);                                                             \
        }                                                                                          \
    }

SURE_EACH_SHAPE(OWN_TEST)

/* Law 1 of sure_float_object_hit. */
TEST(test_rounded)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (case_walk w = walk_regimes(shape, 1, 1000); walk_next(&w);) {
            sure_float_ray ray;
            sure_float_object object;
            sure_hit rounded = {0}, hit = {0};
            sure_float_ray_of(&w.asked.ray, &ray);
            sure_float_object_of(&w.asked.object, &object);
            sure_status status =
                sure_object_hit(&w.asked.ray, &w.asked.object, SURE_TIER_FLOAT32, &hit);
            bool same = sure_float_object_hit(&ray, &object, &rounded) == status &&
                        memcmp(&rounded, &hit, sizeof hit) == 0;
            case_require(&w.asked, same, "what is rounded before is answered alike");
        }
    }
}

static sure_stage certain_by(const sure_ray *ray, sure_object object)
{
    return sure_object_stage(ray, &object, SURE_TIER_CERTAIN);
}

/* A stage answers what the one before it can't: through the middle, past the edge by one ulp, at
 * it, and at it with numbers that 128 bits do not hold. */
TEST(test_stage)
{
    const sure_ray ray = {{0, 0, 9}, {0, 0, -1}, 0, INFINITY};
    const sure_ray beside = {{1 + 0x1p-52, 0, 9}, {0, 0, -1}, 0, INFINITY};
    const sure_ray edge = {{1, 0, 9}, {0, 0, -1}, 0, INFINITY};
    const sure_ray wide = {{1, 0x1p-130, 9}, {0, 0, -1}, 0, INFINITY};
    const sure_object ball = {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, 1}}};
    const sure_object off = {SURE_SHAPE_SPHERE, {.sphere = {{0, 0x1p-130, 0}, 1}}};
    const sure_object bad = {SURE_SHAPE_SPHERE, {.sphere = {{0, 0, 0}, -1}}};
    ck_assert_int_eq(certain_by(&ray, ball), SURE_STAGE_DOUBLE);
    ck_assert_int_eq(certain_by(&beside, ball), SURE_STAGE_DOUBLE_DOUBLE);
    ck_assert_int_eq(certain_by(&edge, ball), SURE_STAGE_MOD128);
    ck_assert_int_eq(certain_by(&wide, off), SURE_STAGE_EXACT);
    ck_assert_int_eq(certain_by(&ray, bad), SURE_STAGE_DOUBLE);
    for (sure_tier tier = 0; tier < SURE_TIER_CERTAIN; tier++)
        ck_assert_int_eq(sure_object_stage(&edge, &ball, tier), SURE_STAGE_DOUBLE);
}

TEST(test_names)
{
    sure_shape shape = SURE_SHAPE_PLANE;
    sure_tier tier = SURE_TIER_FLOAT32;
    for (int i = 0; i < SURE_SHAPES; i++) {
        ck_assert(sure_shape_from_name(sure_shape_name((sure_shape)i), &shape));
        ck_assert_int_eq(shape, i);
    }
    for (int i = 0; i < SURE_TIERS; i++) {
        ck_assert(sure_tier_from_name(sure_tier_name((sure_tier)i), &tier));
        ck_assert_int_eq(tier, i);
    }
    ck_assert(!sure_shape_from_name("torus", &shape) && (int)shape == SURE_SHAPES - 1);
    ck_assert(!sure_tier_from_name("Textbook", &tier) && tier == SURE_TIERS - 1);
    ck_assert_ptr_null(sure_shape_name((sure_shape)SURE_SHAPES));
    ck_assert_ptr_null(sure_tier_name((sure_tier)SURE_TIERS));
    ck_assert_str_eq(sure_stage_name(SURE_STAGE_DOUBLE), "double");
    ck_assert_str_eq(sure_stage_name(SURE_STAGE_EXACT), "exact");
    ck_assert_ptr_null(sure_stage_name((sure_stage)SURE_STAGES));
    ck_assert_str_eq(sure_part_name(SURE_PART_TOP), "top");
    ck_assert_str_eq(sure_field_name(SURE_FIELD_RADIUS), "radius");
    ck_assert_str_eq(sure_status_name(SURE_INVALID), "invalid");
    ck_assert_ptr_null(sure_status_name((sure_status)3));
}

/* Where the way from the centre overflows there is no direction: against the ray. */
TEST(test_normal_of_overflow)
{
    const sure_hit hit = {0, INFINITY, SURE_PART_SURFACE, 0};
    const sure_ray y = {{0, 1.5e308, 0}, {2, 0, 0}, 0, INFINITY};
    const sure_ray z = {{0, 0, 1.5e308}, {2, 0, 0}, 0, INFINITY};
    sure_vec3 against = {-1, 0, 0};
    sure_vec3 by_y = sure_sphere_normal_textbook(&y, &(sure_sphere){{0, -1.5e308, 0}, 1}, &hit);
    sure_vec3 by_z = sure_sphere_normal_textbook(&z, &(sure_sphere){{0, 0, -1.5e308}, 1}, &hit);
    ck_vector_same(by_y, against);
    ck_vector_same(by_z, against);
}

/* A ray in a cylinder's wall comes from no inside, and none leaves a cone by touching its apex. */
TEST(test_leaves)
{
    const sure_object tube = {.shape = SURE_SHAPE_CYLINDER,
                              .as.cylinder = {{0, 0, 0}, {0, 0, 4}, 1}};
    const sure_object hat = {.shape = SURE_SHAPE_CONE, .as.cone = {{0, 0, 0}, {0, 0, 4}, 1}};
    const struct {
        const sure_object *object;
        sure_ray ray;
        double t;
        int leaves;
    } rows[] = {
        {&tube, {{0, 0, -1}, {0, 0, 1}, 0, INFINITY}, 1, 0},
        {&tube, {{0, 0, -1}, {0, 0, 1}, 2, INFINITY}, 5, 1},
        {&tube, {{1, 0, 0}, {0, 0, 1}, 0, INFINITY}, 0, 0},
        {&tube, {{1, 0, 0}, {0, 0, 1}, 2, INFINITY}, 2, 0},
        {&tube, {{1, 0, 0}, {0, 0, 1}, 4, INFINITY}, 4, 0},
        {&hat, {{0, 0, 4}, {0, 0, 1}, 0, INFINITY}, 0, 1},
        {&hat, {{0, 0, 4}, {0, 0, -1}, 0, INFINITY}, 0, 0},
        {&hat, {{0, 0, 4}, {1, 0, 0}, 0, INFINITY}, 0, 0},
        {&hat, {{0, 0, 4}, {1, 0, -4}, 0, INFINITY}, 0, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
            sure_hit hit;
            ck_assert_int_eq(sure_object_hit(&rows[i].ray, rows[i].object, tier, &hit), SURE_HIT);
            ck_assert_double_eq(hit.t, rows[i].t);
            ck_assert_msg(hit.leaves == rows[i].leaves, "row %zu: leaves is %d", i, hit.leaves);
        }
    }
}

SUITE("object")
