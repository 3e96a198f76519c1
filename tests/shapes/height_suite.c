/* SPDX-License-Identifier: MIT */
/* The stem SUBJECT, cone_height or cylinder_height: the end points C -+ h/2 N/|N|, and what lies
 * between them. (That these keep to SURE_END_POINT_ULPS tests/oracles/test_parts.c shows.) */
#include "every_case.h"
#include "hard_points.h"
#include "moved_case.h"
#include "surroundings.h"

#include <signal.h>

typedef sure_field make_object(sure_vec3 centre, sure_vec3 axis, double radius, double height,
                               sure_object *made);
typedef int is_between(sure_vec3 p, const sure_object *object);

#define BETWEEN(shape, tier)                                                                       \
    static int shape##_between_##tier(sure_vec3 p, const sure_object *object)                      \
    {                                                                                              \
        return sure_##shape##_height_##tier(p, &object->as.shape);                                 \
    }

#define STEM(shape, tier)                                                                          \
    static sure_field shape##_##tier(sure_vec3 centre, sure_vec3 axis, double radius,              \
                                     double height, sure_object *made)                             \
    {                                                                                              \
        return sure_##shape##_from_axis_##tier(centre, axis, radius, height, &made->as.shape);     \
    }                                                                                              \
    BETWEEN(shape, tier)

STEM(cone, float32)
STEM(cone, textbook)
BETWEEN(cone, certain)
BETWEEN(cone, exact)
STEM(cylinder, float32)
STEM(cylinder, textbook)
BETWEEN(cylinder, certain)
BETWEEN(cylinder, exact)

/* Points of the double cone around (0, y, 0) with walls at 45 degrees: those within the slant
 * height of the apex at y = 4, below it. */
static void check_cone(is_between *between)
{
    const sure_object cone = {SURE_SHAPE_CONE, {.cone = {{0, 0, 0}, {0, 4, 0}, 4}}};
    for (int y = -4; y <= 12; y++) {
        ck_assert_int_eq(between((sure_vec3){4 - y, y, 0}, &cone), y >= 0 && y <= 4);
        ck_assert_int_eq(between((sure_vec3){0, y, y - 4}, &cone), y >= 0 && y <= 4);
    }
    /* wherever the viewer stands */
    const sure_object ahead = {SURE_SHAPE_CONE, {.cone = {{0, 0, -10}, {0, 0, -6}, 4}}};
    const sure_object behind = {SURE_SHAPE_CONE, {.cone = {{0, 0, 6}, {0, 0, 10}, 4}}};
    ck_assert_int_eq(between((sure_vec3){2, 0, -8}, &ahead), 1);
    ck_assert_int_eq(between((sure_vec3){2, 0, -4}, &ahead), 0);
    ck_assert_int_eq(between((sure_vec3){0, 2, 8}, &behind), 1);
    ck_assert_int_eq(between((sure_vec3){0, 2, 12}, &behind), 0);
}

/* N.(P - top) <= 0 <= N.(P - base): the ends belong to it, the distance from the axis does not
 * matter. */
static void check_cylinder(is_between *between)
{
    const sure_object oblique = {SURE_SHAPE_CYLINDER, {.cylinder = {{1, 1, 1}, {2, 2, 1}, 1}}};
    for (int x = -3; x <= 5; x++) {
        for (int y = -3; y <= 5; y++) {
            int height = (x - 1) + (y - 1); /* of 2 */
            ck_assert_int_eq(between((sure_vec3){x, y, 9}, &oblique), height >= 0 && height <= 2);
        }
    }
    for (int k = 0; k <= 2; k++) /* on the axis itself, half way too */
        ck_assert_int_eq(between((sure_vec3){1 + k / 2.0, 1 + k / 2.0, 1}, &oblique), 1);
}

/* The heights have two tiers that promise and no stable. */
enum { HEIGHT_FLOAT32, HEIGHT_TEXTBOOK, HEIGHT_CERTAIN, HEIGHT_EXACT, HEIGHT_TIERS };

typedef struct {
    make_object *make[PART_TIERS];
    is_between *between[HEIGHT_TIERS];
    void (*check)(is_between *);
    sure_field upper; /* the field that names the other end */
} stem;

#define STEM_OF(shape, check, upper)                                                               \
    {                                                                                              \
        {shape##_float32, shape##_textbook},                                                       \
            {shape##_between_float32, shape##_between_textbook, shape##_between_certain,           \
             shape##_between_exact},                                                               \
            check, upper                                                                           \
    }

static const stem stems[SURE_SHAPES] = {
    [SURE_SHAPE_CYLINDER] = STEM_OF(cylinder, check_cylinder, SURE_FIELD_TOP),
    [SURE_SHAPE_CONE] = STEM_OF(cone, check_cone, SURE_FIELD_APEX),
};
static const stem *const subject = &stems[SUBJECT];

LOOP_TEST(test_between, HEIGHT_TIERS)
{
    subject->check(subject->between[_i]);
}

typedef struct {
    double radius;
    int between;
} height_truth;

static void set_between(true_line *l, void *context)
{
    height_truth *truth = context;
    int below = mpfr_cmp(l->level, l->height) <= 0;
    if (l->tapers) { /* from the apex */
        TRUE_NUMBERS(l->bits, reach);
        mpfr_set_d(reach, truth->radius, MPFR_RNDN);
        mpfr_sqr(reach, reach, MPFR_RNDN);
        mpfr_add(reach, reach, l->height, MPFR_RNDN);
        below = mpfr_cmp(l->mm, reach) <= 0;
    }
    truth->between = below && mpfr_sgn(l->level) >= 0;
}

/* By the notes' own form, in numbers that nothing is rounded in. */
static void require_true(sure_vec3 p, const sure_object *object, is_between *between, int in)
{
    const sure_case c = {.ray = {p, {1, 0, 0}, 0, INFINITY}, .object = *object};
    height_truth truth = {.radius = object->as.cylinder.radius};
    surroundings_set(in);
    int given = between(p, object);
    surroundings_set(0);
    true_exactly(&c, set_between, &truth);
    case_require(&c, given == truth.between, surroundings_name(in));
}

/* A solid and a point that are hard to tell, sizes 2^+-spread. */
static sure_object solid_at(uint64_t i, int spread, sure_vec3 *point)
{
    const sure_object solid = {
        SUBJECT,
        {.cylinder = {suite_doubles(11, i, spread), suite_doubles(14, i, spread),
                      fabs(suite_double(17, i, spread))}}};
    *point = hard_point(&solid, suite_bits(18, i));
    return solid;
}

/* Certain and exact are right in every environment, where textbook is not. */
static void expect_truth(uint64_t count, int spread, int percent)
{
    uint64_t wrong = 0;
    for (uint64_t i = 0; i < count; i++) {
        sure_vec3 p;
        sure_object solid = solid_at(i, spread, &p);
        int at = (int)(i % SURROUNDINGS);
        require_true(p, &solid, subject->between[HEIGHT_CERTAIN], at);
        require_true(p, &solid, subject->between[HEIGHT_EXACT], at);
        wrong += subject->between[HEIGHT_TEXTBOOK](p, &solid) !=
                 subject->between[HEIGHT_EXACT](p, &solid);
    }
    ck_assert_msg(100 * wrong >= (uint64_t)percent * count, "textbook is wrong %d times",
                  (int)wrong);
}

TEST(test_hard_points)
{
    expect_truth(20000, 3, 1);
    expect_truth(3000, 1000, 0);
}

/* Points and solids in whole numbers: ties. */
TEST(test_ties)
{
    for (uint64_t i = 0; i < 20000; i++) {
        int limit = i % 2 ? 6 : 1 << 20;
        const sure_object solid = {
            SUBJECT,
            {.cylinder = {suite_integers(1, i, limit), suite_integers(4, i, limit),
                          abs(suite_integer(7, i, limit))}}};
        sure_vec3 p = i % 3 ? suite_integers(8, i, limit) : hard_point(&solid, suite_bits(11, i));
        if (!same_place(solid.as.cylinder.base, solid.as.cylinder.top))
            require_true(p, &solid, subject->between[HEIGHT_CERTAIN], (int)(i % SURROUNDINGS));
    }
}

/* Laws 3 to 6. */
LOOP_TEST(test_height_laws, HEIGHT_TIERS)
{
    static const turn mirrored = {{0, 1, 2}, {1, -1, 1}}, exchanged = {{1, 0, 2}, {1, 1, 1}};
    is_between *between = subject->between[_i];
    for (uint64_t i = 0; i < 5000; i++) {
        sure_case given = {.object.shape = SUBJECT}, moved[3];
        given.object = solid_at(i, 3, &given.ray.origin);
        sure_object other = given.object;
        sure_cylinder *solid = &given.object.as.cylinder, *changed = &other.as.cylinder;
        int is = between(given.ray.origin, &given.object);
        ck_assert_int_eq(between(solid->base, &given.object), 1);
        ck_assert_int_eq(between(solid->top, &given.object), 1);
        changed->radius *= 1 + fabs(suite_double(19, i, 0));
        if (SUBJECT == SURE_SHAPE_CONE) {
            ck_assert_int_ge(between(given.ray.origin, &other), is);
        } else {
            changed->base = solid->top;
            changed->top = solid->base;
            ck_assert_int_eq(between(given.ray.origin, &other), is);
        }
        ck_assert(case_scaled(&given, (int[NUMBER_KINDS]){[IS_LENGTH] = -40}, &moved[0]));
        moved[1] = case_turned(&given, &mirrored);
        moved[2] = case_turned(&given, &exchanged);
        for (int k = 0; k < 3; k++)
            ck_assert_int_eq(between(moved[k].ray.origin, &moved[k].object), is);
    }
}

/* Both shapes have two ends, the base first, and a radius. */
static sure_field make(int tier, sure_vec3 centre, sure_vec3 axis, double radius, double height,
                       sure_vec3 ends[2])
{
    sure_object made;
    sure_field bad = subject->make[tier](centre, axis, radius, height, &made);
    if (bad == SURE_FIELD_NONE) {
        ends[0] = made.as.cylinder.base;
        ends[1] = made.as.cylinder.top;
        ck_double_same(made.as.cylinder.radius, suite_rounded(tier, radius));
    }
    return bad;
}

static void expect_ends(int tier, sure_vec3 centre, sure_vec3 axis, double height, sure_vec3 low,
                        sure_vec3 high)
{
    sure_vec3 ends[2];
    ck_assert_int_eq(make(tier, centre, axis, 1, height, ends), SURE_FIELD_NONE);
    ck_vector_same(ends[0], low);
    ck_vector_same(ends[1], high);
}

LOOP_TEST(test_known, PART_TIERS)
{
    expect_ends(_i, (sure_vec3){1, 2, 3}, (sure_vec3){0, 5, 0}, 6, (sure_vec3){1, -1, 3},
                (sure_vec3){1, 5, 3});
    expect_ends(_i, (sure_vec3){0, 0, 0}, (sure_vec3){3, 0, -4}, 20, (sure_vec3){-6, 0, 8},
                (sure_vec3){6, 0, -8});
}

static sure_vec3 vector(uint64_t stream, uint64_t index, int spread)
{
    return (sure_vec3){suite_single(stream, index, spread), suite_single(stream + 1, index, spread),
                       suite_single(stream + 2, index, spread)};
}

LOOP_TEST(test_laws, PART_TIERS)
{
    int most = _i == SURE_TIER_FLOAT32 ? 30 : 900;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 c = vector(1, i, 4), n = vector(4, i, 4), plain[2];
        int k = suite_integer(7, i, most);
        ck_assert_int_eq(make(_i, c, n, 1, 2, plain), SURE_FIELD_NONE);
        expect_ends(_i, c, (sure_vec3){-n.x, -n.y, -n.z}, 2, plain[1], plain[0]);
        expect_ends(_i, c, (sure_vec3){ldexp(n.x, k), ldexp(n.y, k), ldexp(n.z, k)}, 2, plain[0],
                    plain[1]);
    }
}

static void refused(int tier, sure_vec3 centre, sure_vec3 axis, double radius, double height,
                    sure_field expected)
{
    sure_vec3 ends[2] = {{7, 7, 7}, {7, 7, 7}}, before[2] = {{7, 7, 7}, {7, 7, 7}};
    ck_assert_int_eq(make(tier, centre, axis, radius, height, ends), expected);
    ck_assert(memcmp(ends, before, sizeof ends) == 0);
}

LOOP_TEST(test_invalid, PART_TIERS)
{
    const sure_vec3 zero = {0, 0, 0}, y = {0, 1, 0};
    const double most = _i == SURE_TIER_FLOAT32 ? FLT_MAX : DBL_MAX;
    refused(_i, (sure_vec3){NAN, 0, 0}, y, 1, 1, SURE_FIELD_CENTRE);
    refused(_i, zero, zero, 1, 1, SURE_FIELD_NORMAL);
    refused(_i, zero, (sure_vec3){0, INFINITY, 0}, 1, 1, SURE_FIELD_NORMAL);
    refused(_i, zero, y, 1, 0, subject->upper);
    refused(_i, zero, y, 1, -1, subject->upper);
    refused(_i, zero, y, 1, NAN, subject->upper);
    refused(_i, zero, y, 1, INFINITY, subject->upper);
    refused(_i, (sure_vec3){0, 1e17, 0}, y, 1, 1, subject->upper);
    refused(_i, (sure_vec3){0, most, 0}, y, 1, most, subject->upper);
    refused(_i, zero, y, -1, 1, SURE_FIELD_RADIUS);
    refused(_i, zero, y, NAN, 1, SURE_FIELD_RADIUS);
}

/* What a double holds and a float does not. */
LOOP_TEST(test_as_the_tier_has_it, PART_TIERS)
{
    static const struct {
        sure_vec3 centre, axis;
        double radius;
        sure_field bad; /* of float32 */
    } rows[] = {
        {{1e300, 0, 0}, {0, 1, 0}, 1, SURE_FIELD_CENTRE},
        {{0, 0, 0}, {0, 1e-60, 0}, 1, SURE_FIELD_NORMAL},
        {{0, 0, 0}, {0, 1e300, 0}, 1, SURE_FIELD_NORMAL},
        {{0, 0, 0}, {0, 1, 0}, 1e300, SURE_FIELD_RADIUS},
        {{0, 0, 0}, {0, 1, 0}, 0.1, SURE_FIELD_NONE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        sure_vec3 ends[2];
        ck_assert_int_eq(make(_i, rows[i].centre, rows[i].axis, rows[i].radius, 1, ends),
                         _i == SURE_TIER_FLOAT32 ? rows[i].bad : SURE_FIELD_NONE);
    }
}

SIGNAL_TEST(test_ends_in_one_point, SIGABRT)
{
    const sure_object flat = {SUBJECT, {.cylinder = {{1, 2, 3}, {1, 2, 3}, 1}}};
    subject->between[HEIGHT_CERTAIN]((sure_vec3){0, 0, 0}, &flat);
}

SUITE("height")
