/* SPDX-License-Identifier: MIT */
/* The laws of floats.h, over all regimes made of floats, as they come and among subnormal floats
 * and near the greatest ones; ties of floats, and what is a tie in doubles alone. */
#include "bisection_result.h"
#include "case_floats.h"
#include "every_case.h"
#include "surroundings.h"

#include <stdarg.h>

enum { TRUE_BITS = 8000, SIZES = 4 };

/* x as a float; a call keeps the rounding, which GCC 12 drops of neighbours. */
static __attribute__((noinline)) float narrow(double x)
{
    return (float)x;
}

/* Bits, but for zeros' signs where one is not +0. */
static bool same_float(float x, float y)
{
    return memcmp(&x, &y, sizeof x) == 0;
}

static bool same_floats(sure_float_vec3 v, sure_float_vec3 w)
{
    return same_float(v.x, w.x) && same_float(v.y, w.y) && same_float(v.z, w.z);
}

static bool same_hit(const sure_hit_f *x, const sure_hit_f *y)
{
    return same_float(x->t, y->t) && x->part == y->part && x->leaves == y->leaves;
}

/* The case with its lengths, steps and normals times powers of two: 2^-130 and 2^80 leave most of
 * them floats. False where that makes a valid one invalid. */
static bool sized(const sure_case *c, int size, sure_case *made)
{
    static const int shifts[SIZES][NUMBER_KINDS] = {
        [1] = {[IS_LENGTH] = -130, [IS_STEP] = -130},
        [2] = {[IS_LENGTH] = 80, [IS_STEP] = -30, [IS_NORMAL] = -140, [IS_TIME] = 110},
        [3] = {[IS_LENGTH] = -100, [IS_STEP] = 30, [IS_NORMAL] = 100, [IS_TIME] = -130}};
    sure_case scaled = *c;
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        double *x = case_number(&scaled, i);
        *x = ldexp(*x, shifts[size][case_number_kind(c->object.shape, i)]);
    }
    return float_case(&scaled, made);
}

/* Every case of floats: `each` is called for it. */
typedef void each_float(const sure_case *c, const float_query *q);
static void each_of(sure_shape shape, uint64_t seed, uint64_t count, each_float *each)
{
    unsigned long asked = 0, of_size[SIZES] = {0};
    for (case_walk w = walk_regimes(shape, seed, count); walk_next(&w);) {
        for (int size = 0; size < SIZES; size++) {
            sure_case made;
            if (!sized(&w.asked, size, &made))
                continue;
            const float_query q = float_query_of(&made);
            each(&made, &q);
            asked++;
            of_size[size]++;
        }
    }
    printf("%s: %lu cases of floats\n", sure_shape_name(shape), asked);
    for (int size = 0; size < SIZES; size++)
        ck_assert_uint_gt(of_size[size], count);
}

/* t* of the first hit, from numbers wide enough to be exact, as a float. */
static float true_t(const sure_case *c)
{
    TRUE_NUMBERS(TRUE_BITS, t);
    TRUE_LINE(TRUE_BITS, line);
    true_line_set(&line, c);
    ck_assert(true_first(&line, t));
    return mpfr_get_flt(t, MPFR_RNDN) + 0.0F;
}

static void is_true(const sure_case *c, const float_query *q)
{
    const bisection_result truth = bisection_of(c);
    for (sure_tier tier = SURE_TIER_CERTAIN; tier <= SURE_TIER_EXACT; tier++) {
        sure_hit_f hit = {-7, SURE_PARTS, -7};
        const sure_hit_f before = hit;
        const sure_status status = float_query_hit(q, tier, &hit);
        case_require(c, status == truth.status, "the decision");
        case_require(c, status == SURE_HIT || same_hit(&hit, &before), "outputs untouched");
        case_require(c, float_query_check(q) == truth.field, "the field");
        if (status != SURE_HIT)
            continue;
        case_require(c, hit.part == truth.part, "the part");
        case_require(c, same_float(hit.t, true_t(c)), "t");
    }
}

SHAPE_TEST(test_truth)
{
    each_of((sure_shape)_i, 5, 40, is_true);
}

/* Law 1: what exact says, rounded. */

/* Do both neighbours of a correctly rounded number become one float? */
static bool is_no_tie(double x)
{
    return narrow(step_ulps(x, -1)) == narrow(step_ulps(x, 1));
}

static void component_is(const sure_case *c, float exact, float certain, double of_double)
{
    case_require(c, !is_no_tie(of_double) || same_float(exact, narrow(of_double) + 0.0F),
                 "a component of exact_f's normal");
    case_require(c, fabs(certain - of_double) <= SURE_FLOAT_NORMAL_ERROR + 0x1p-53,
                 "a component of certain_f's normal");
}

static void is_exact(const sure_case *c, const float_query *q)
{
    sure_hit exact;
    sure_hit_f hit;
    const sure_status status = sure_object_hit(&c->ray, &c->object, SURE_TIER_EXACT, &exact);
    case_require(c, float_query_hit(q, SURE_TIER_EXACT, &hit) == status, "law 1, the status");
    if (status != SURE_HIT)
        return;
    case_require(c, hit.part == exact.part && hit.leaves == exact.leaves, "law 1, the end");
    case_require(c, !is_no_tie(exact.t) || same_float(hit.t, narrow(exact.t) + 0.0F), "law 1, t");
    const sure_vec3 n = sure_object_normal(&c->ray, &c->object, SURE_TIER_EXACT, &exact);
    const sure_float_vec3 certain_f = float_query_normal(q, SURE_TIER_CERTAIN, &hit);
    const sure_float_vec3 exact_f = float_query_normal(q, SURE_TIER_EXACT, &hit);
    component_is(c, exact_f.x, certain_f.x, n.x);
    component_is(c, exact_f.y, certain_f.y, n.y);
    component_is(c, exact_f.z, certain_f.z, n.z);
}

SHAPE_TEST(test_exact)
{
    each_of((sure_shape)_i, 6, 60, is_exact);
}

/* Far rays, as float engines have them: spheres of radius 1/2 to 2 about the origin, seen from
 * far away. Single precision does not tell hits from misses there: what hits a sphere smaller by
 * a fiftieth is missed, and what misses a larger one is hit. */

enum { FAR_RAYS = 20000 };

static sure_case far_ray(double distance, uint64_t i, double radius)
{
    double numbers[CASE_NUMBERS_MAX] = {[AT_T_MAX] = INFINITY, [AT_OBJECT + 3] = radius};
    sure_case c;
    for (int k = 0; k < 3; k++) {
        const double aim = 1.5 * radius * suite_double(71 + (uint64_t)k, i, 0);
        numbers[k] = narrow(distance * (k == 2) + suite_double(74 + (uint64_t)k, i, 0));
        numbers[AT_D + k] = aim - numbers[k];
    }
    c = case_from_numbers(SURE_SHAPE_SPHERE, numbers);
    ck_assert(float_case(&c, &c));
    return c;
}

/* Does the ray meet the sphere when its radius is multiplied? */
static bool meets(sure_case c, double factor)
{
    c.object.as.sphere.radius *= factor;
    return sure_object_hit(&c.ray, &c.object, SURE_TIER_EXACT, &(sure_hit){0}) == SURE_HIT;
}

static void check_far(double distance)
{
    int must_hit = 0, must_miss = 0, missed = 0, hit = 0;
    for (uint64_t i = 0; i < FAR_RAYS; i++) {
        const double radius = narrow(1.25 + 0.75 * suite_double(70, i, 0));
        const sure_case c = far_ray(distance, i, radius);
        const float_query q = float_query_of(&c);
        is_exact(&c, &q);
        sure_hit unused;
        const bool single =
            sure_object_hit(&c.ray, &c.object, SURE_TIER_FLOAT32, &unused) == SURE_HIT;
        if (meets(c, 0.98)) {
            must_hit++;
            missed += !single;
        } else if (!meets(c, 1.02)) {
            must_miss++;
            hit += single;
        }
    }
    printf("from %g: float32 misses %.1f %% of %d hits, hits %.1f %% of %d misses; certain_f 0\n",
           distance, 100.0 * missed / must_hit, must_hit, 100.0 * hit / must_miss, must_miss);
    ck_assert_int_gt(must_hit, FAR_RAYS / 5);
    ck_assert_int_gt(must_miss, FAR_RAYS / 5);
    ck_assert_int_gt(100 * missed, 20 * must_hit);
    ck_assert_int_gt(100 * hit, 40 * must_miss);
}

TEST(test_far_rays)
{
    check_far(12000);
    check_far(100000);
}

/* Law 2. */

typedef struct {
    sure_field field;
    sure_status status[2];
    sure_hit_f hit[2];
    sure_float_vec3 normal[2];
} all_answers;

static void answer_all(const float_query *q, all_answers *all)
{
    all->field = float_query_check(q);
    for (int i = 0; i < 2; i++) {
        const sure_tier tier = i == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
        all->status[i] = float_query_hit(q, tier, &all->hit[i]);
        if (all->status[i] == SURE_HIT)
            all->normal[i] = float_query_normal(q, tier, &all->hit[i]);
    }
}

static void is_everywhere(const sure_case *c, const float_query *q)
{
    void (*volatile answer)(const float_query *, all_answers *) = answer_all;
    all_answers usual = {0}, other;
    answer_all(q, &usual);
    for (int e = 1; e < SURROUNDINGS_ALL; e++) {
        memset(&other, 0, sizeof other);
        surroundings_set(e);
        answer(q, &other);
        surroundings_set(0);
        bool same = usual.field == other.field;
        for (int i = 0; i < 2; i++) {
            same = same && usual.status[i] == other.status[i] &&
                   same_hit(&usual.hit[i], &other.hit[i]);
            /* certain's normals may differ in their last digits */
            same = same && (i == 0 || same_floats(usual.normal[i], other.normal[i]));
        }
        ck_assert_msg(same, "law 2, rounding %s: %s", surroundings_name(e), case_text(c));
    }
}

SHAPE_TEST(test_environments)
{
    each_of((sure_shape)_i, 7, 12, is_everywhere);
}

/* Ties. Numbers that are one in doubles and none in truth: only the exact stage tells them. */

static float_query query_of(const char *format, ...)
{
    char line[CASE_LINE_MAX];
    sure_case c, rounded;
    va_list more;
    va_start(more, format);
    vsnprintf(line, sizeof line, format, more);
    va_end(more);
    ck_assert_msg(case_read(line, &c) && float_case(&c, &rounded), "%s", line);
    for (int i = 0; i < case_numbers(c.object.shape); i++)
        ck_double_same(*case_number(&rounded, i), *case_number(&c, i)); /* they are floats */
    return float_query_of(&c);
}

static sure_hit_f hit_of(const float_query *q)
{
    sure_hit_f hit = {0};
    ck_assert_int_eq(float_query_hit(q, SURE_TIER_EXACT, &hit), SURE_HIT);
    return hit;
}

static void float_is(float x, double expected, const char *what, int n, int side)
{
    ck_assert_msg(same_float(x, narrow(expected)), "%s %d %d: %a, not %a", what, n, side, (double)x,
                  expected);
}

/* 1 + n 2^-23 + 2^-24 and a little more or less, or nothing, is midway between 1 + n 2^-23 and the
 * next float; a tie goes to the even one. */
#define EACH_TIE                                                                                   \
    for (int n = 0; n < 2; n++)                                                                    \
        for (int side = -1; side <= 1; side++)

static void tie_is(const float_query *q, int n, int side)
{
    const int up = side == 0 ? n : side > 0;
    float_is(hit_of(q).t, 1 + (n + up) * 0x1p-23, sure_shape_name(q->shape), n, side);
}

/* The ray starts at z = 1 + n 2^-23, at x = 1, and the surface is at z = -2^-24; tilted along x. */
TEST(test_tie_of_planes)
{
    EACH_TIE
    {
        const double z = 1 + n * 0x1p-23, tilt = side * 0x1p-57;
        float_query q = query_of("plane 1 0 %a 0 0 -1 0 inf 0 0 -0x1p-24 %a 0 1", z, tilt);
        tie_is(&q, n, side);
        q = query_of("disc 1 0 %a 0 0 -1 0 inf 0 0 -0x1p-24 %a 0 1 2", z, tilt);
        tie_is(&q, n, side);
        q = query_of("box 0 0 %a 0 0 -1 0 inf -1 -1 -1 1 1 -0x1p-24", z);
        tie_is(&q, n, 0);
    }
}

/* A circle of radius 1/4 whose top or bottom is at z = -2^-24, beside the ray by 2^-29: there it is
 * entered by 2^-57 later, left by as much sooner. */
TEST(test_tie_of_rounds)
{
    EACH_TIE
    {
        const double z = 1 + n * 0x1p-23, beside = side == 0 ? 0 : 0x1p-29;
        const double centre = (side < 0 ? 0.25 : -0.25) - 0x1p-24, t_min = side < 0 ? 0.75 : 0;
        float_query q =
            query_of("sphere 0 0 %a 0 0 -1 %a inf %a 0 %a 0.25", z, t_min, beside, centre);
        tie_is(&q, n, side);
        q = query_of("cylinder 0 0 %a 0 0 -1 %a inf %a -1 %a %a 1 %a 0.25", z, t_min, beside,
                     centre, beside, centre);
        tie_is(&q, n, side);
        q = query_of("cone 0 0 %a 0 0 -1 %a inf %a -1 %a %a 1 %a 0.5", z, t_min, beside, centre,
                     beside, centre);
        tie_is(&q, n, side);
        ck_assert_int_eq(hit_of(&q).leaves, side < 0);
    }
}

/* The normal's x is that of a point 1/2 + n 2^-24 + 2^-25 beside the middle of a circle of radius
 * 1, and what the ray has gone by 2^-60 aside. */
TEST(test_tie_of_normals)
{
    EACH_TIE
    {
        const int up = side == 0 ? n : side > 0;
        const double x = 0.5 + n * 0x1p-24, aside = side * 0x1p-60,
                     right = 0.5 + (n + up) * 0x1p-24;
        float_query q = query_of("sphere %a 0 2 %a 0 -1 0 inf -0x1p-25 0 0 1", x, aside);
        sure_hit_f hit = hit_of(&q);
        float_is(float_query_normal(&q, SURE_TIER_EXACT, &hit).x, right, "sphere", n, side);
        q = query_of("cylinder %a 0 2 %a 0 -1 0 inf -0x1p-25 -1 0 -0x1p-25 1 0 1", x, aside);
        hit = hit_of(&q);
        float_is(float_query_normal(&q, SURE_TIER_EXACT, &hit).x, right, "cylinder", n, side);
    }
}

/* Beyond floats, and less than all of them. */
TEST(test_ends)
{
    float_query q = query_of("plane 0 0 0 0 0 0x1p-149 0 inf 0 0 0x1p127 0 0 1");
    float_is(hit_of(&q).t, INFINITY, "far", 0, 0);
    q = query_of("plane 0 0 0 0 0 0x1p127 0 inf 0 0 0x1p-149 0 0 1");
    float_is(hit_of(&q).t, 0, "near", 0, 0);
    q = query_of("plane 0 0 0 0 0 2 0 inf 0 0 0x1p-149 0 0 1"); /* a tie */
    float_is(hit_of(&q).t, 0, "half the least float", 0, 0);
    q = query_of("plane 0 0 0 0 0 2 0 inf 0 0 0x3p-149 0 0 1"); /* likewise */
    float_is(hit_of(&q).t, 0x1p-148, "3/2 of it", 0, 0);
    q = query_of("plane 0 0 1 0 0 1 -0 inf 0 0 1 0 0 1");
    float_is(hit_of(&q).t, 0, "at the start", 0, 0);
}

SUITE("floats")
