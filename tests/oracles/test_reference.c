/* What the reference alone answers, against answers reasoned out by hand. */
#include <math.h>

#include <mpfr.h>

#include "reference.h"
#include "reference_answer.h"
#include "suite.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* <case> -> the signs behind it. */
typedef struct {
    const char *question;
    reference_decisions signs;
} signs_case;

#define NONE REFERENCE_NONE

static const signs_case signs_cases[] = {
    {"plane 0 0 4 0 0 -1 0 inf 0 0 0 0 0 1",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 1 5",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, 0, NONE}},
    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 1 6",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, -1, NONE}},
    {"disc 9 5 0 1 0 0 0 inf 0 0 0 0 0 1 5",
     {NONE, 0, 0, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 2 0 1 0 0 0 inf 0 0 0 1", {1, -1, NONE, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 1 0 1 0 0 0 inf 0 0 0 1", {1, 0, NONE, 1, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 0 0 1 0 0 0 inf 0 0 0 1", {1, 1, NONE, 2, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"cylinder -2 0 -1 1 0 1 0 inf 0 0 0 0 0 2 1", {1, 1, 1, 2, {0, 1}, {-1, 0}, 0, 0}},
    {"cylinder -2 0 -2 1 0 1 0 inf 0 0 0 0 0 2 1", {1, 1, 1, 2, {-1, 1}, {-1, -1}, -1, 1}},
    {"cylinder 1 0 -2 0 0 1 0 inf 0 0 0 0 0 2 1", {0, 0, 1, 0, {NONE, NONE}, {NONE, NONE}, 0, 0}},
    {"cylinder 9 0 5 1 0 0 0 inf 0 0 0 0 0 2 1", {1, 1, 0, 2, {1, 1}, {1, 1}, NONE, NONE}},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3", {-1, 1, -1, 2, {1, 1}, {1, -1}, -1, NONE}},
    {"cone -10 0 4 1 0 0 0 inf 0 0 0 0 0 4 3", {1, 0, 0, 1, {1, NONE}, {0, NONE}, NONE, NONE}},
    {"cone -5 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", {0, 1, 1, 1, {1, NONE}, {-1, NONE}, -1, NONE}},
    {"cone -3 0 8 3 0 -4 0 inf 0 0 0 0 0 4 3", {0, 0, -1, 0, {NONE, NONE}, {NONE, NONE}, 0, NONE}},
};

START_TEST(test_signs)
{
    const reference_decisions *ought = &signs_cases[_i].signs;
    sure_case question = case_of(signs_cases[_i].question);
    reference_decisions is;
    ck_assert_int_eq(reference_decide(&question.ray, &question.object, &is), SURE_HIT);
    ck_assert_int_eq(is.leading, ought->leading);
    ck_assert_int_eq(is.discriminant, ought->discriminant);
    ck_assert_int_eq(is.axis, ought->axis);
    ck_assert_int_eq(is.roots, ought->roots);
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(is.base_side[i], ought->base_side[i]);
        ck_assert_int_eq(is.top_side[i], ought->top_side[i]);
    }
    ck_assert_int_eq(is.base_cap, ought->base_cap);
    ck_assert_int_eq(is.top_cap, ought->top_cap);
}
END_TEST

/* On a miss or an invalid input nothing is written; a NULL output is none. */
START_TEST(test_outputs)
{
    static const char *lines[] = {"sphere 0 9 0 1 0 0 0 inf 0 0 0 1",
                                  "sphere 0 9 0 0 0 0 0 inf 0 0 0 1"};
    for (size_t i = 0; i < COUNT(lines); i++) {
        sure_case q = case_of(lines[i]);
        double t = 77;
        sure_part part = SURE_PART_TOP;
        sure_vec3 n = {77, 78, 79};
        int sign = 77;
        sure_status status = reference_hit(&q.ray, &q.object, &t, &part, &n);
        ck_assert_int_eq(status, i == 0 ? SURE_MISS : SURE_INVALID);
        ck_assert_int_eq(reference_compare_hit(&q.ray, &q.object, 0, &sign), status);
        ck_assert_int_eq(reference_hit_within(&q.ray, &q.object, 0, INFINITY, &sign), status);
        ck_assert_int_eq(reference_normal_within(&q.ray, &q.object, n, INFINITY, &sign), status);
        ck_assert(t == 77 && part == SURE_PART_TOP && n.x == 77 && n.y == 78 && n.z == 79);
        ck_assert_int_eq(sign, 77);
    }
    sure_case q = case_of("sphere -5 0 0 1 0 0 0 inf 0 0 0 1");
    sure_case second = case_of("sphere 0 0 0 1 0 0 0 1 0 5 0 1");
    int order = 77;
    ck_assert_int_eq(reference_hit_order(&q.ray, &q.object, &second.object, &order), SURE_MISS);
    second.object.as.sphere.radius = NAN;
    ck_assert_int_eq(reference_hit_order(&q.ray, &q.object, &second.object, &order), SURE_INVALID);
    ck_assert_int_eq(order, 77);
    ck_assert_int_eq(reference_hit(&q.ray, &q.object, NULL, NULL, NULL), SURE_HIT);
    ck_assert_int_eq(reference_interval(&q.ray, &q.object, NULL), SURE_HIT);
}
END_TEST

static int compared(const char *line, double x)
{
    sure_case question = case_of(line);
    int sign = 77;
    reference_compare_hit(&question.ray, &question.object, x, &sign);
    return sign;
}

static int within(const char *line, double t, double error)
{
    sure_case question = case_of(line);
    int is = 77;
    reference_hit_within(&question.ray, &question.object, t, error, &is);
    return is;
}

static int normal_within(const char *line, sure_vec3 normal, double error)
{
    sure_case question = case_of(line);
    int is = 77;
    reference_normal_within(&question.ray, &question.object, normal, error, &is);
    return is;
}

START_TEST(test_comparisons)
{
    static const char third[] = "plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0";
    static const char four[] = "sphere -5 0 0 1 0 0 0 inf 0 0 0 1";
    static const char beyond[] = "plane 0 0 0 0x1p-900 0 0 0 inf 0x1p900 0 0 1 0 0";
    ck_assert_int_eq(compared(third, 1.0 / 3), 1);
    ck_assert_int_eq(compared(third, nextafter(1.0 / 3, 1)), -1);
    ck_assert_int_eq(compared(four, 4), 0);
    ck_assert_int_eq(compared(four, nextafter(4, 5)), -1);
    ck_assert_int_eq(compared(four, INFINITY), -1);
    ck_assert_int_eq(compared(beyond, -INFINITY), 1);
    ck_assert_int_eq(compared(beyond, 0x1.fffffffffffffp+1023), 1);
    ck_assert_int_eq(compared(beyond, INFINITY), -1);

    /* 1/3 = 0x1.5555555555555p-2 + 2^-54 / 3, and the double 0x1.5555555555556p-56 is above
     * 2^-54 / 3. */
    ck_assert(within(third, 0x1.5555555555555p-2, 0x1.5555555555556p-56));
    ck_assert(!within(third, 0x1.5555555555555p-2, 0x1.5555555555555p-56));
    ck_assert(!within(third, 1.0 / 3, 0));
    ck_assert(within(four, 4, 0));
    ck_assert(within(four, 3, 1) && within(four, 5, 1));
    ck_assert(!within(four, 3, nextafter(1, 0)) && !within(four, 5, nextafter(1, 0)));
    ck_assert(within(four, 0, INFINITY) && within(beyond, 0, INFINITY));
    ck_assert(!within(beyond, INFINITY, INFINITY) && !within(four, NAN, INFINITY));
    ck_assert(!within(four, 4, NAN) && !within(four, 4, -1));

    /* The normal (-1, 0, 0) and, on the cone, (-4/5, 0, 3/5): 0.8 is 4/5 + 2^-53 2/5. */
    static const char side[] = "cone -10 0 2 1 0 0 0 inf 0 0 0 0 0 4 3";
    ck_assert(normal_within(four, (sure_vec3){-1, 0, 0}, 0));
    ck_assert(normal_within(four, (sure_vec3){-1, 0.5, 0}, 0.5));
    ck_assert(!normal_within(four, (sure_vec3){-1, nextafter(0.5, 1), 0}, 0.5));
    ck_assert(!normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0));
    ck_assert(normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0x1p-54));
    ck_assert(!normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0x1p-57));

    ck_assert_uint_eq(reference_ulps(1, 1), 0);
    ck_assert_uint_eq(reference_ulps(1, nextafter(1, 2)), 1);
    ck_assert_uint_eq(reference_ulps(1, nextafter(1, 0)), 1);
    ck_assert_uint_eq(reference_ulps(-0.0, 0.0), 0);
    ck_assert_uint_eq(reference_ulps(-0x1p-1074, 0x1p-1074), 2);
    ck_assert_uint_eq(reference_ulps(1, 2), UINT64_C(1) << 52);
    ck_assert_uint_eq(reference_ulps(INFINITY, 0x1.fffffffffffffp+1023), 1);
    ck_assert_uint_eq(reference_ulps(-INFINITY, INFINITY), UINT64_C(0xffe0000000000000));
    ck_assert_uint_eq(reference_ulps(NAN, 1), UINT64_MAX);
}
END_TEST

/* object fields of a case (its ray is not asked), point -> side. */
typedef struct {
    const char *object;
    sure_vec3 point;
    int side;
} place_case;

#define ANY_RAY " 0 0 0 1 0 0 0 1 "

static const place_case place_cases[] = {
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, 1}, 0},
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, 0x1.0000000000001p+0}, 1},
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, -1}, -1},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0}, 0},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {1, 1, 0}, 0},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0x1p-1074}, 1},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 0x1.0000000000001p+2, 0}, 1},
    {"sphere" ANY_RAY "0 0 0 5", {3, 4, 0}, 0},
    {"sphere" ANY_RAY "0 0 0 5", {3, 4, 0x1p-1074}, 1},
    {"sphere" ANY_RAY "0 0 0 5", {3, 0x1.fffffffffffffp+1, 0}, -1},
    {"sphere" ANY_RAY "1 0 0 0", {1, 0, 0}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 1}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 2}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0x1.0000000000001p+1}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, 0}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, -0x1p-1074}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, 0x1p-1074}, -1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 0x1.0000000000001p+2, 1}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 0", {0, 0, 1}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {0, 0, 4}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {0, 0, 0x1.0000000000001p+2}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 2}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 0x1.fffffffffffffp+0}, -1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0x1p-1074, 2}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 6}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {3, 0, 0}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 0", {0, 0, 1}, 0},
};

START_TEST(test_places)
{
    const place_case *hand = &place_cases[_i];
    sure_case question = case_of(hand->object);
    ck_assert_msg(reference_where(&question.object, hand->point) == hand->side, "%s at %a %a %a",
                  hand->object, hand->point.x, hand->point.y, hand->point.z);
    sure_ray ray = {{0, 0, 0}, hand->point, 0, 1};
    if (hand->point.x != 0 || hand->point.y != 0 || hand->point.z != 0)
        ck_assert_int_eq(reference_where_at(&ray, &question.object, 1), hand->side);
}
END_TEST

/* 3 t rounds to 1 for the double t next to 1/3, but o + t d itself is not on the plane x = 1. */
START_TEST(test_place_on_the_ray)
{
    sure_case question = case_of("plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0");
    ck_assert_int_eq(reference_where_at(&question.ray, &question.object, 0x1.5555555555555p-2), -1);
    ck_assert_int_eq(reference_where_at(&question.ray, &question.object, 0x1.5555555555556p-2), 1);
}
END_TEST

typedef struct {
    const char *question;
    sure_status status;
    double t;
    const char *why;
} wall_case;

static const wall_case wall_cases[] = {
    {"cylinder -5 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", SURE_HIT, 4, "above the top"},
    {"cylinder 0 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", SURE_HIT, 1, "from inside"},
    {"cylinder 1 0 9 0 0 1 0.5 inf 0 0 0 0 0 2 1", SURE_HIT, 0.5, "along the wall: t_min"},
    {"cylinder 0.5 0 9 0 0 1 0 inf 0 0 0 0 0 2 1", SURE_MISS, 0, "along it, inside"},
    {"cylinder -5 0 9 1 0 0 0 inf 0 0 0 0 0 2 0", SURE_HIT, 5, "radius 0: the axis"},
    {"cylinder 0 0 9 0 0 1 2 inf 0 0 0 0 0 2 0", SURE_HIT, 2, "along it"},
    {"cone -10 0 6 1 0 0 0 inf 0 0 0 0 0 4 3", SURE_HIT, 8.5, "the other nappe"},
    {"cone -10 0 -4 1 0 0 0 inf 0 0 0 0 0 4 3", SURE_HIT, 4, "below the base: radius 6"},
    {"cone 0 0 9 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, 5, "the apex, from the other nappe"},
    {"cone 0 0 9 0 0 -1 0x1.4000000000001p+2 inf 0 0 0 0 0 4 3", SURE_MISS, 0, "beyond it"},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, 0x1.5555555555555p+1,
     "a < 0: out of the other nappe at z = 16/3"},
    {"cone -3 0 8 3 0 -4 0.25 inf 0 0 0 0 0 4 3", SURE_HIT, 0.25, "along a generator: t_min"},
    {"cone -7 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", SURE_HIT, 0x1.1555555555555p+1,
     "a = 0: 3 t - 7 = 3 t - 6 never, 7 - 3 t = 3 t - 6 at 13/6"},
    {"cone 0 0 4 0 0 0 0 inf 0 0 0 0 0 4 3", SURE_INVALID, 0, "d = 0"},
};

START_TEST(test_walls)
{
    const wall_case *hand = &wall_cases[_i];
    sure_case question = case_of(hand->question);
    double t = 77;
    ck_assert_msg(reference_wall_hit(&question.ray, &question.object, &t) == hand->status, "%s",
                  hand->why);
    ck_assert_msg(same_number(t, hand->status == SURE_HIT ? hand->t : 77), "%s: %a", hand->why, t);
}
END_TEST

START_TEST(test_wall_normals)
{
    sure_object cylinder = case_of("cylinder" ANY_RAY "0 0 0 0 0 2 1").object;
    sure_object cone = case_of("cone" ANY_RAY "0 0 0 0 0 4 3").object;
    sure_object thin = case_of("cone" ANY_RAY "0 0 0 0 0 4 0").object;
    sure_vec3 slanted = {0.8, 0, 0.6}, up = {0, 0, 1}, out = {0.6, 0.8, 0}, none = {0, 0, 0};
    ck_vector_same(reference_wall_normal(&cylinder, (sure_vec3){3, 4, 9}), out);
    ck_vector_same(reference_wall_normal(&cylinder, (sure_vec3){0, 0, 9}), none);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){1.5, 0, 2}), slanted);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){6, 0, -4}), slanted);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){0, 0, 4}), up);
    /* |PQ| = 4, cos = 4/5: S is 5 below the apex, a step further down than P, which is the
     * base's centre. */
    ck_vector_same(reference_wall_normal(&cone, none), up);
    ck_vector_same(reference_wall_normal(&thin, (sure_vec3){0, 0, 1}), none);
    /* |PQ| = 5, cos = 1: S is 5 below the apex and P = (3, 0, 0) is (3, 0, 1) from it. */
    ck_vector_same(reference_wall_normal(&thin, (sure_vec3){3, 0, 0}),
                   (sure_vec3){0x1.e5b9d136c6d96p-1, 0, 0x1.43d136248490fp-2});
}
END_TEST

START_TEST(test_heights)
{
    sure_object cylinder = case_of("cylinder" ANY_RAY "0 0 0 0 0 2 1").object;
    sure_object cone = case_of("cone" ANY_RAY "0 0 0 0 0 4 3").object;
    ck_assert(reference_height(&cylinder, (sure_vec3){9, 9, 0}));
    ck_assert(reference_height(&cylinder, (sure_vec3){9, 9, 2}));
    ck_assert(!reference_height(&cylinder, (sure_vec3){9, 9, -0x1p-1074}));
    ck_assert(!reference_height(&cylinder, (sure_vec3){9, 9, 0x1.0000000000001p+1}));
    ck_assert(reference_height(&cone, (sure_vec3){3, 0, 0}));
    ck_assert(!reference_height(&cone, (sure_vec3){3, 0, -0x1p-1074}));
    ck_assert(reference_height(&cone, (sure_vec3){0, 0, 4}));
    ck_assert(!reference_height(&cone, (sure_vec3){0, 0, 0x1.0000000000001p+2}));
    ck_assert(!reference_height(&cone, (sure_vec3){3, 0, 8}));
    ck_assert(reference_height(&cone, (sure_vec3){0, 0, -1}));
}
END_TEST

START_TEST(test_end_points)
{
    sure_vec3 low, high;
    reference_end_points((sure_vec3){1, 2, 3}, (sure_vec3){0, 3, -4}, 10, &low, &high);
    ck_vector_same(low, (sure_vec3){1, -1, 7});
    ck_vector_same(high, (sure_vec3){1, 5, -1});
    reference_end_points((sure_vec3){0, 0, 0}, (sure_vec3){0x1p1023, 0x1p1023, 0}, 2, &low, &high);
    ck_vector_same(high, (sure_vec3){0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0});
    ck_vector_same(low, (sure_vec3){-0x1.6a09e667f3bcdp-1, -0x1.6a09e667f3bcdp-1, 0});
    /* 1 + 2^-53 is halfway to the next double, and 1 even; 1 - 2^-54 halfway, and 1 even again. */
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){0x1p-1074, 0, 0}, 0x1p-52, &low, &high);
    ck_vector_same(high, (sure_vec3){1, 1, 1});
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){5, 0, 0}, 0x1p-53, &low, &high);
    ck_vector_same(low, (sure_vec3){1, 1, 1});
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){5, 0, 0}, 0x1.0000000000001p-53, &low,
                         &high);
    ck_vector_same(low, (sure_vec3){0x1.fffffffffffffp-1, 1, 1});
}
END_TEST

typedef struct {
    double a, half_b, c;
    sure_roots count;
    double low, high;
    const char *why;
} roots_case;

#define LARGEST 0x1.fffffffffffffp+1023

static const roots_case roots_cases[] = {
    {0, 0, 0, SURE_ROOTS_ALL, 77, 78, "every t"},
    {0, -0.0, 0x1p-1074, SURE_ROOTS_NONE, 77, 78, "0 = c"},
    {0, 3, -2, SURE_ROOTS_ONE, 0x1.5555555555555p-2, 78, "2 / 6"},
    {1, 1, 1, SURE_ROOTS_TWO, -1, -1, "a double root, twice"},
    {1, 1, 0x1.0000000000001p+0, SURE_ROOTS_NONE, 77, 78, "D/4 = -2^-52"},
    {-1, 0, 4, SURE_ROOTS_TWO, -2, 2, "a < 0: in order"},
    {1, 0, 0, SURE_ROOTS_TWO, 0, 0, "+0 twice"},
    {2, -3, 0, SURE_ROOTS_TWO, 0, 3, "one is 0"},
    {1, 0, -2, SURE_ROOTS_TWO, -0x1.6a09e667f3bcdp+0, 0x1.6a09e667f3bcdp+0, "sqrt 2"},
    {1, -0x1p600, 1, SURE_ROOTS_TWO, 0x1p-601, 0x1p601, "2^-601 and a root just below 2^601"},
    {0x1p-1074, 0x1p1000, -0x1p1000, SURE_ROOTS_TWO, -INFINITY, 0.5, "-2^2075 overflows"},
    {0x1p1000, 0x1p1000, 0x1p-1074, SURE_ROOTS_TWO, -2, 0, "-2^-2075 rounds to +0"},
    {0x1p1000, 0x1p1000, -0x1.8p-74, SURE_ROOTS_TWO, -2, 0x1p-1074, "3/4 of the least double"},
    {LARGEST, LARGEST, LARGEST, SURE_ROOTS_TWO, -1, -1, "products overflow"},
    /* A root's numerator divides c: halfway between two doubles it can only be below the normal
     * ones. */
    {0, 1, -0x3p-1074, SURE_ROOTS_ONE, 0x2p-1074, 78, "1.5 least doubles: 2 is even"},
    {0, -1, 0x5p-1074, SURE_ROOTS_ONE, 0x2p-1074, 78, "2.5 least doubles: 2 is even"},
};

START_TEST(test_quadratic)
{
    const roots_case *hand = &roots_cases[_i];
    double roots[2] = {77, 78};
    sure_roots count = reference_quadratic(hand->a, hand->half_b, hand->c, roots);
    ck_assert_msg(count == hand->count && same_number(roots[0], hand->low) &&
                      same_number(roots[1], hand->high),
                  "%s: %d roots, %a %a", hand->why, (int)count, roots[0], roots[1]);
}
END_TEST

START_TEST(test_projections)
{
    sure_vec3 v = {1, 2, 3}, n = {0, 0x1.8p1000, -0x1p1001};
    /* n.v / n.n n = (6 - 12) / 25 (0, 3, -4) in n's own unit */
    ck_vector_same(reference_project(v, n), (sure_vec3){0, -0.72, 0.96});
    ck_vector_same(reference_reflect(v, n), (sure_vec3){-1, -3.44, -1.08});
    sure_vec3 across = {4, -3, 7}, none = {0, 0, 0}, diagonal = {1, 1, 1};
    ck_vector_same(reference_project(across, (sure_vec3){3, 4, 0}), none);
    ck_assert(!signbit(reference_project((sure_vec3){-0.0, 0, -0.0}, n).x));
    /* A third of 2^1023 three times over: nothing overflows on the way. */
    sure_vec3 far = {0x1p1023, 0x1p1023, 0x1p1023}, edge = {0, LARGEST, LARGEST};
    ck_vector_same(reference_project(far, diagonal), far);
    ck_vector_same(reference_reflect(edge, diagonal),
                   (sure_vec3){INFINITY, 0x1.5555555555555p+1022, 0x1.5555555555555p+1022});
}
END_TEST

/* y cos(angle) - z sin(angle) in one rounding from far more digits than the cases below can
 * need. */
static double turned(double angle, double y, double z)
{
    mpfr_t w, c, s;
    mpfr_inits2(6000, w, c, s, (mpfr_ptr)NULL);
    mpfr_set_d(w, angle, MPFR_RNDN);
    mpfr_sin_cos(s, c, w, MPFR_RNDN);
    mpfr_mul_d(c, c, y, MPFR_RNDN);
    mpfr_mul_d(s, s, z, MPFR_RNDN);
    mpfr_sub(c, c, s, MPFR_RNDN);
    double x = mpfr_get_d(c, MPFR_RNDN);
    mpfr_clears(w, c, s, (mpfr_ptr)NULL);
    return x == 0 ? 0 : x;
}

START_TEST(test_rotation)
{
    sure_vec3 v = {3, 4, 5};
    ck_vector_same(reference_rotate(0, 0, v), v);
    ck_vector_same(reference_rotate(1, -0.0, v), v);
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){7, 0, 0}), (sure_vec3){7, 0, 0});
    /* Right-handed: +y to +z, +z to +x, +x to +y; sin(1), cos(1). */
    double s = 0x1.aed548f090ceep-1, c = 0x1.14a280fb5068cp-1;
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){0, 1, 0}), (sure_vec3){0, c, s});
    ck_vector_same(reference_rotate(1, 1, (sure_vec3){0, 0, 1}), (sure_vec3){s, 0, c});
    ck_vector_same(reference_rotate(2, 1, (sure_vec3){1, 0, 0}), (sure_vec3){c, s, 0});
    /* 1.5 (least - least^3 / 6) is just below halfway between the least double and twice it. */
    ck_vector_same(reference_rotate(2, 0x1p-1074, (sure_vec3){1.5, 0, 0}),
                   (sure_vec3){1.5, 0x1p-1074, 0});
    /* 1 - 2^-121 + 2^-53 - ... is just below halfway between 1 and the next double. */
    ck_vector_same(reference_rotate(2, 0x1p-60, (sure_vec3){1, -0x1p7, 0}),
                   (sure_vec3){1, -0x1p7, 0});
    /* The double next to cot(1): cos(1) - cot(1) sin(1) loses 53 bits. */
    double cot = 0x1.48c05d04e1cfep-1;
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){0, 1, cot}),
                   (sure_vec3){0, turned(1, 1, cot), turned(1, cot, -1)});
    for (uint64_t i = 0; i < 2000; i++) {
        double angle = suite_double(1, i, 1 << (i % 9));
        double y = suite_double(2, i, 1 << (i % 10)), z = suite_double(3, i, 1 << (i % 10));
        sure_vec3 x = reference_rotate(0, angle, (sure_vec3){9, y, z});
        ck_vector_same(x, (sure_vec3){9, turned(angle, y, z), turned(angle, z, -y)});
        sure_vec3 about_y = reference_rotate(1, angle, (sure_vec3){z, 9, y});
        ck_vector_same(about_y, (sure_vec3){x.z, 9, x.y});
        sure_vec3 about_z = reference_rotate(2, angle, (sure_vec3){y, z, 9});
        ck_vector_same(about_z, (sure_vec3){x.y, x.z, 9});
    }
}
END_TEST

/* tan by way of the angle, not of the turn; MPFR's own pi. */
static double extent(double focal_length, double fov)
{
    mpfr_t x;
    mpfr_init2(x, 6000);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_d(x, x, fov, MPFR_RNDN);
    mpfr_div_ui(x, x, 360, MPFR_RNDN);
    mpfr_tan(x, x, MPFR_RNDN);
    mpfr_mul_d(x, x, focal_length, MPFR_RNDN);
    mpfr_mul_ui(x, x, 2, MPFR_RNDN);
    double result = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return result;
}

START_TEST(test_viewport)
{
    ck_double_same(reference_viewport_extent(1.5, 90), 3);
    ck_double_same(reference_viewport_extent(0x1.fffffffffffffp+1023, 90), INFINITY);
    ck_double_same(reference_viewport_extent(0x1p-1074, 90), 0x1p-1073);
    /* 2 tan(30 degrees) = 2 / sqrt 3, 2 tan(60 degrees) = 2 sqrt 3 */
    ck_double_same(reference_viewport_extent(1, 60), 0x1.279a74590331cp+0);
    ck_double_same(reference_viewport_extent(1, 120), 0x1.bb67ae8584caap+1);
    for (uint64_t i = 0; i < 2000; i++) {
        double fov = fabs(suite_double(4, i, i % 2 ? 7 : 300)), f = fabs(suite_double(5, i, 400));
        if (fov > 0 && fov < 180 && f > 0)
            ck_double_same(reference_viewport_extent(f, fov), extent(f, fov));
    }
    ck_double_same(reference_viewport_extent(3, nextafter(180, 0)), extent(3, nextafter(180, 0)));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("reference");
    add_looped(suite, "signs", test_signs, COUNT(signs_cases));
    add_looped(suite, "outputs", test_outputs, 1);
    add_looped(suite, "comparisons", test_comparisons, 1);
    add_looped(suite, "places", test_places, COUNT(place_cases));
    add_looped(suite, "places on the ray", test_place_on_the_ray, 1);
    add_looped(suite, "walls", test_walls, COUNT(wall_cases));
    add_looped(suite, "wall normals", test_wall_normals, 1);
    add_looped(suite, "heights", test_heights, 1);
    add_looped(suite, "end points", test_end_points, 1);
    add_looped(suite, "quadratic", test_quadratic, COUNT(roots_cases));
    add_looped(suite, "projections", test_projections, 1);
    add_looped(suite, "rotation", test_rotation, 1);
    add_looped(suite, "viewport", test_viewport, 1);
    return suite_run(suite);
}
