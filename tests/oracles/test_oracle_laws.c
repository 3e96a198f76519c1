/* SPDX-License-Identifier: MIT */
/* The laws of reference/bisection.h, by their numbers, bit for bit, of each oracle: over small
 * integers, a grid, full mantissas, and every regime. */
#include "../support/every_case.h"
#include "../support/moved_case.h"
#include "oracle.h"

enum { DRAWN = 300, OF_A_REGIME = 40, SEED = 20 };

static const oracle *asked;
static long applied;

/* Numbers of a random case: small integers, a grid of 2^-20, or full mantissas, by `kind`. */
enum { SMALL, GRID, FULL, KINDS };

static double random_number(int kind, uint64_t stream, uint64_t index)
{
    if (kind == SMALL)
        return suite_integer(stream, index, 3);
    if (kind == GRID)
        return ldexp(suite_integer(stream, index, 1 << 22), -20);
    return suite_double(stream, index, 8);
}

static sure_case random_case(sure_shape shape, int kind, uint64_t index)
{
    sure_case c = {.object.shape = shape};
    uint64_t stream = (uint64_t)shape * KINDS + (uint64_t)kind + 100;
    for (int i = 0; i < case_numbers(shape); i++)
        *case_number(&c, i) = random_number(kind, stream, index * CASE_NUMBERS_MAX + (uint64_t)i);
    if (shape_has(shape, SURE_KIND_RADIUS))
        object_mend(shape, case_number(&c, AT_OBJECT));
    sure_ray *ray = &c.ray;
    ray->t_min = index % 2 == 0 ? 0 : fabs(ray->t_min) / 4;
    ray->t_max = index % 3 == 0 ? INFINITY : ray->t_min + fabs(ray->t_max);
    return c;
}

/* It has all 53 bits: it is not infinite and was not rounded among the subnormals, or to 0. */
static bool full(double t)
{
    return fabs(t) > 0x1p-1022 && fabs(t) < INFINITY;
}

/* Where t does not have all its bits, before or after, its rounding differs: then it is not
 * compared. */
static void scale_t(double *t, double answered, int power)
{
    bool exact = full(*t) && full(answered) && full(ldexp(*t, power));
    *t = exact ? ldexp(*t, power) : answered;
}

static void expect_scaled(const sure_case *from, const int powers[NUMBER_KINDS], const char *why)
{
    sure_case to;
    if (!case_scaled(from, powers, &to))
        return;
    bisection_result expected = asked->answer(from), got = asked->answer(&to);
    scale_t(&expected.t, got.t, powers[IS_TIME]);
    scale_t(&expected.interval.t_enter, got.interval.t_enter, powers[IS_TIME]);
    scale_t(&expected.interval.t_leave, got.interval.t_leave, powers[IS_TIME]);
    bisection_expect(&to, &got, &expected, why);
    applied++;
}

static int power_of(uint64_t index)
{
    static const int powers[] = {1, -3, 200, -200, 400, -400};
    return powers[index % 6];
}

/* Law 1. */
static void scaling(const sure_case *q, uint64_t index)
{
    int k = power_of(index);
    expect_scaled(q, (int[]){[IS_LENGTH] = k, [IS_TIME] = k, [IS_NORMAL] = 0}, "lengths scaled");
}

/* Law 2. */
static void direction_scaling(const sure_case *q, uint64_t index)
{
    int k = power_of(index);
    expect_scaled(q, (int[]){[IS_STEP] = k, [IS_TIME] = -k, [IS_NORMAL] = 0}, "direction scaled");
}

static void normal_scaling(const sure_case *q, uint64_t index)
{
    if (shape_has(q->object.shape, SURE_KIND_NORMAL))
        expect_scaled(q, (int[]){[IS_NORMAL] = power_of(index)}, "normal scaled");
}

/* Law 3, of permutations and reflections. Normals have no -0. Faces across the axes have other
 * names then, and what is wrong with one corner may be so with the other. */
static void axes(const sure_case *q, uint64_t index)
{
    static const turn by = {{1, 2, 0}, {1, -1, 1}};
    sure_case turned = case_turned(q, &by);
    bisection_result expected = asked->answer(q), got = asked->answer(&turned);
    (void)index;
    sure_vec3 n = vector_turned(expected.normal, &by);
    expected.normal = (sure_vec3){n.x + 0.0, n.y + 0.0, n.z + 0.0};
    if (shape_has(q->object.shape, SURE_KIND_HIGH)) {
        expected.field = got.field;
        expected.part = got.part;
        expected.normal = got.normal;
        expected.interval.enter_part = got.interval.enter_part;
        expected.interval.leave_part = got.interval.leave_part;
    }
    bisection_expect(&turned, &got, &expected, "axes exchanged and mirrored");
    applied++;
}

/* Adds the step; false where that rounds. Knuth's sum: its second part is the rounding error. */
static bool move(double *x, double step)
{
    double sum = *x + step, other = sum - *x;
    bool exact = (*x - (sum - other)) + (step - other) == 0;
    *x = sum;
    return exact;
}

static bool move_point(double *point, double step)
{
    bool x = move(point, step), y = move(point + 1, 2 * step), z = move(point + 2, -step);
    return x && y && z;
}

static double step_of(uint64_t index)
{
    static const double steps[] = {1, -3, 1024, 0x1p-20};
    return steps[index % 4];
}

/* Law 4. */
static void translation(const sure_case *q, uint64_t index)
{
    const sure_shape_info *info = sure_shape_info_of(q->object.shape);
    sure_case moved = *q;
    bool exact = move_point(case_number(&moved, AT_O), step_of(index));
    for (int i = 0; i < info->field_count; i++) {
        const sure_shape_field *field = &info->fields[i];
        double *point = case_number(&moved, AT_OBJECT + field->at);
        if (field->kind != SURE_KIND_RADIUS && field->kind != SURE_KIND_NORMAL)
            exact = move_point(point, step_of(index)) && exact;
    }
    if (!exact)
        return;
    bisection_result expected = asked->answer(q), got = asked->answer(&moved);
    bisection_expect(&moved, &got, &expected, "everything moved");
    applied++;
}

/* Law 5, for 3 d, where that is exact, and an x of 50 bits, so that 3 x is exact. */
static void threefold_direction(const sure_case *q, uint64_t index)
{
    sure_case plain = *q;
    (void)index;
    plain.ray.t_min = 0;
    plain.ray.t_max = INFINITY;
    sure_case threefold = plain;
    for (int i = AT_D; i < AT_D + 3; i++) {
        double *x = case_number(&threefold, i), third = *x;
        *x *= 3;
        if (third != 0 && (fma(3, third, -*x) != 0 || !full(*x)))
            return;
    }
    bisection_result before = asked->answer(&plain), after = asked->answer(&threefold);
    ck_assert_int_eq(before.status, after.status);
    ck_assert_int_eq(before.part, after.part);
    ck_assert(bisection_same_vector(before.normal, after.normal));
    applied++;
    if (before.status != SURE_HIT || !full(after.t))
        return;
    int exponent;
    double mantissa = frexp(after.t, &exponent);
    for (int step = -1; step <= 1; step++) {
        double x = ldexp(rint(ldexp(mantissa, 50)) + step, exponent - 50);
        ck_assert_int_eq(asked->compare(&threefold, x), asked->compare(&plain, 3 * x));
    }
}

/* Law 6. */
static void other_way_up(const sure_case *q, uint64_t index)
{
    static const sure_part other[] = {SURE_PART_SURFACE, SURE_PART_TOP, SURE_PART_BASE,
                                      SURE_PART_WALL};
    const sure_shape_info *info = sure_shape_info_of(q->object.shape);
    bisection_result expected = asked->answer(q);
    (void)index;
    if (info->fields[1].name != SURE_FIELD_TOP || expected.status == SURE_INVALID)
        return;
    sure_case turned = *q;
    turned.object.as.cylinder.base = q->object.as.cylinder.top;
    turned.object.as.cylinder.top = q->object.as.cylinder.base;
    bisection_result got = asked->answer(&turned);
    if (expected.status == SURE_HIT)
        expected.part = other[expected.part];
    if (expected.interval_status == SURE_HIT) {
        expected.interval.enter_part = other[expected.interval.enter_part];
        expected.interval.leave_part = other[expected.interval.leave_part];
    }
    bisection_expect(&turned, &got, &expected, "other way up");
    applied++;
}

static sure_status between(const sure_case *q, double t_min, double t_max)
{
    sure_case cut = *q;
    cut.ray.t_min = t_min;
    cut.ray.t_max = t_max;
    return asked->answer(&cut).status;
}

/* Laws 7 and 8: t_min and t_max at t and its neighbours take or lose the hit as t* itself says. */
static void range_ends(const sure_case *q, uint64_t index)
{
    bisection_result is = asked->answer(q);
    (void)index;
    if (is.status != SURE_HIT)
        return;
    int sign = asked->compare(q, is.t);
    double before = nextafter(is.t, -INFINITY), after = nextafter(is.t, INFINITY);
    ck_assert_int_eq(asked->compare(q, before), 1);
    ck_assert_int_eq(asked->compare(q, INFINITY), -1);
    ck_assert_int_eq(asked->compare(q, -INFINITY), 1);
    applied++;
    if (is.t == INFINITY)
        return;
    ck_assert_int_eq(asked->compare(q, after), -1);
    if (is.t >= q->ray.t_min)
        ck_assert_int_eq(between(q, q->ray.t_min, is.t), sign <= 0 ? SURE_HIT : SURE_MISS);
    if (before >= q->ray.t_min)
        ck_assert_int_eq(between(q, q->ray.t_min, before), SURE_MISS);
    if (before >= 0)
        ck_assert_int_eq(between(q, before, after), SURE_HIT);
    if (sign >= 0 && is.t <= q->ray.t_max) {
        sure_case cut = *q;
        cut.ray.t_min = is.t;
        bisection_result got = asked->answer(&cut);
        bisection_expect(&cut, &got, &is, "t_min at the hit");
    }
}

/* Law 9, with the object of the case before. */
static void order_of_pairs(const sure_case *q, uint64_t index)
{
    static sure_case last;
    sure_case second = {.ray = q->ray, .object = last.object};
    bisection_result x = asked->answer(q);
    (void)index;
    last = *q;
    if (x.status != SURE_HIT)
        return;
    ck_assert_int_eq(asked->order(&q->ray, &q->object, &q->object), 0);
    bisection_result y = asked->answer(&second);
    if (y.status != SURE_HIT)
        return;
    int order = asked->order(&q->ray, &q->object, &second.object);
    ck_assert_int_eq(asked->order(&q->ray, &second.object, &q->object), -order);
    if (x.t != y.t)
        ck_assert_int_eq(order, x.t < y.t ? -1 : 1);
    applied++;
}

typedef void law(const sure_case *q, uint64_t index);

static law *const laws[] = {scaling,      direction_scaling, normal_scaling,
                            axes,         translation,       threefold_direction,
                            other_way_up, range_ends,        order_of_pairs};
enum { LAWS = sizeof laws / sizeof *laws };

LOOP_TEST(test_laws, ORACLES *LAWS)
{
    law *holds = laws[_i % LAWS];
    asked = &oracles[_i / LAWS];
    applied = 0;
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (uint64_t i = 0; i < KINDS * DRAWN; i++) {
            sure_case q = random_case(shape, (int)(i % KINDS), i / KINDS);
            holds(&q, i / KINDS);
        }
        for (case_walk w = walk_regimes(shape, SEED, OF_A_REGIME); walk_next(&w);)
            holds(&w.asked, w.index);
    }
    ck_assert_int_gt(applied, DRAWN);
}

SUITE("oracle laws")
