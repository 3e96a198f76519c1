/* The first oracle against laws that must hold bit for bit, against other routes to the truth
 * (CGAL's kernels, the definition at exact points), and against cases whose truth follows from
 * how they were made. */
#include <math.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "case_file.h"
#include "reference.h"
#include "reference_answer.h"
#include "regimes.h"
#include "suite.h"
#include "surroundings.h"

/* Everything below runs over the named regimes: case `index` of each that the shape knows. */
enum { SEED = 20, CASES = 60 };

typedef void law(const sure_case *question);

static void each_regime_case(sure_shape shape, uint64_t cases, law *check)
{
    for (int which = 0; which < REGIMES; which++) {
        if (!regime_applies(shape, (regime)which))
            continue;
        for (uint64_t index = 0; index < cases; index++) {
            sure_case question = regime_case(shape, (regime)which, SEED, index);
            check(&question);
        }
    }
}

/* The chord passes its proof; plane, disc and sphere get the same one from CGAL's kernels. */
static void other_routes_agree(const sure_case *q)
{
    sure_interval chord = {0, 0, SURE_PART_SURFACE, SURE_PART_SURFACE}, by_kernel = chord;
    sure_status status = reference_interval(&q->ray, &q->object, &chord);
    if (status == SURE_INVALID) {
        ck_assert_int_eq(reference_hit(&q->ray, &q->object, NULL, NULL, NULL), SURE_INVALID);
        return;
    }
    ck_assert_msg(reference_certify(&q->ray, &q->object), "not proved: %s", text_of(q));
    if (q->object.shape <= SURE_SHAPE_SPHERE) {
        ck_assert_msg(reference_kernel_interval(&q->ray, &q->object, &by_kernel) == status &&
                          memcmp(&by_kernel, &chord, sizeof chord) == 0,
                      "CGAL's kernel differs: %s", text_of(q));
    }
}

START_TEST(test_other_routes)
{
    each_regime_case((sure_shape)_i, CASES, other_routes_agree);
}
END_TEST

static int sign_of_hit_minus(const sure_case *q, double x)
{
    int sign = 77;
    reference_compare_hit(&q->ray, &q->object, x, &sign);
    return sign;
}

static sure_status hit_between(const sure_case *q, double t_min, double t_max)
{
    sure_ray ray = q->ray;
    ray.t_min = t_min;
    ray.t_max = t_max;
    return reference_hit(&ray, &q->object, NULL, NULL, NULL);
}

/* Moving t_min and t_max to t and its neighbours takes or loses the hit as its real t* says. */
static void window_decides(const sure_case *q)
{
    double t;
    if (reference_hit(&q->ray, &q->object, &t, NULL, NULL) != SURE_HIT || t == INFINITY)
        return;
    int sign = sign_of_hit_minus(q, t);
    double before = nextafter(t, -INFINITY), after = nextafter(t, INFINITY);
    ck_assert_int_eq(sign_of_hit_minus(q, before), 1);
    ck_assert_int_eq(sign_of_hit_minus(q, after), -1);
    if (t >= q->ray.t_min)
        ck_assert_int_eq(hit_between(q, q->ray.t_min, t), sign <= 0 ? SURE_HIT : SURE_MISS);
    if (before >= q->ray.t_min)
        ck_assert_int_eq(hit_between(q, q->ray.t_min, before), SURE_MISS);
    if (before >= 0)
        ck_assert_int_eq(hit_between(q, before, after), SURE_HIT);
    int within = 77;
    double half_step = ldexp(after - t, -1);
    reference_hit_within(&q->ray, &q->object, t, half_step, &within);
    ck_assert_int_eq(within, half_step > 0 || sign == 0);
}

START_TEST(test_window)
{
    each_regime_case((sure_shape)_i, CASES, window_decides);
}
END_TEST

/* Where the numbers of a case stand (case_to_numbers); those of the object begin with a point. */
enum { ORIGIN = 0, DIRECTION = 3, T_RANGE = 6, OBJECT = 8, SECOND = OBJECT + 3 };

static bool second_is_point(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

static bool second_is_normal(sure_shape shape)
{
    return shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC;
}

static void turn_axes(double v[3])
{
    double x = v[0];
    v[0] = v[1];
    v[1] = 0 - v[2];
    v[2] = x;
}

/* x -> y, y -> -z, z -> x of everything does the same to the normal and changes nothing else. */
static void axes_do_not_matter(const sure_case *q)
{
    sure_shape shape = q->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(q, numbers);
    turn_axes(numbers + ORIGIN);
    turn_axes(numbers + DIRECTION);
    turn_axes(numbers + OBJECT);
    if (shape != SURE_SHAPE_SPHERE)
        turn_axes(numbers + SECOND);
    sure_case other = case_from_numbers(shape, numbers);
    case_answer expected = reference_answer_of(q);
    double normal[3] = {expected.normal.x, expected.normal.y, expected.normal.z};
    turn_axes(normal);
    expected.normal = (sure_vec3){normal[0], normal[1], normal[2]};
    expect_answer(&other, &expected, "axes exchanged and mirrored");
}

START_TEST(test_axes)
{
    each_regime_case((sure_shape)_i, CASES, axes_do_not_matter);
}
END_TEST

/* Multiplies `count` numbers by 2^power; false where that rounds. */
static bool scale(double *numbers, int count, int power)
{
    bool exact = true;
    for (int i = 0; i < count; i++) {
        double scaled = ldexp(numbers[i], power);
        exact = exact && (ldexp(scaled, -power) == numbers[i] || isnan(scaled));
        numbers[i] = scaled;
    }
    return exact;
}

/* t has all 53 bits: it is not infinite and was not rounded among the subnormal numbers. */
static bool full(double t)
{
    return t > 0x1p-1022 && t < INFINITY;
}

static int applied;

/* t scaled by 2^power; where not all its bits are there, before or after, its rounding differs. */
static void expect_scaled(const sure_case *from, const double *numbers, int power, const char *why)
{
    sure_case to = case_from_numbers(from->object.shape, numbers);
    case_answer expected = reference_answer_of(from), answer = reference_answer_of(&to);
    if (full(expected.t) && full(answer.t) && full(ldexp(expected.t, power)))
        expected.t = ldexp(expected.t, power);
    else
        expected.t = answer.t;
    expect_answer(&to, &expected, why);
    applied++;
}

/* Points, radius and t range times 2^power. */
static void scale_lengths(const sure_case *q, int power)
{
    sure_shape shape = q->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(q, numbers);
    bool exact = scale(numbers + ORIGIN, 3, power) && scale(numbers + T_RANGE, 2, power) &&
                 scale(numbers + OBJECT, 3, power) &&
                 scale(numbers + SECOND, second_is_point(shape) ? 3 : 0, power) &&
                 scale(numbers + case_numbers(shape) - 1, shape != SURE_SHAPE_PLANE, power);
    if (exact)
        expect_scaled(q, numbers, power, "lengths times a power of two");
}

/* d times 2^power, the t range times 2^-power. */
static void scale_direction(const sure_case *q, int power)
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(q, numbers);
    if (scale(numbers + DIRECTION, 3, power) && scale(numbers + T_RANGE, 2, -power))
        expect_scaled(q, numbers, -power, "direction times a power of two");
}

static void scale_normal(const sure_case *q, int power)
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(q, numbers);
    if (second_is_normal(q->object.shape) && scale(numbers + SECOND, 3, power))
        expect_scaled(q, numbers, 0, "normal times a power of two");
}

static void scales_do_not_matter(const sure_case *q)
{
    static const int powers[] = {1, -3, 200, -200};
    for (int i = 0; i < 4; i++) {
        scale_lengths(q, powers[i]);
        scale_direction(q, powers[i]);
        scale_normal(q, powers[i]);
    }
}

START_TEST(test_scales)
{
    applied = 0;
    each_regime_case((sure_shape)_i, CASES, scales_do_not_matter);
    ck_assert_int_gt(applied, 20 * CASES);
}
END_TEST

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

static void place_does_not_matter(const sure_case *q)
{
    static const double steps[] = {1, -3, 1024, 0x1p-20};
    sure_shape shape = q->object.shape;
    for (int i = 0; i < 4; i++) {
        double numbers[CASE_NUMBERS_MAX];
        case_to_numbers(q, numbers);
        if (!move_point(numbers + ORIGIN, steps[i]) || !move_point(numbers + OBJECT, steps[i]) ||
            (second_is_point(shape) && !move_point(numbers + SECOND, steps[i])))
            continue;
        sure_case moved = case_from_numbers(shape, numbers);
        case_answer expected = reference_answer_of(q);
        expect_answer(&moved, &expected, "everything moved");
        applied++;
    }
}

START_TEST(test_moves)
{
    applied = 0;
    each_regime_case((sure_shape)_i, CASES, place_does_not_matter);
    ck_assert_int_gt(applied, CASES);
}
END_TEST

static sure_part other_end(sure_part part)
{
    if (part == SURE_PART_WALL)
        return part;
    return part == SURE_PART_BASE ? SURE_PART_TOP : SURE_PART_BASE;
}

static void ends_exchange(const sure_case *q)
{
    sure_case turned_over = *q;
    turned_over.object.as.cylinder.base = q->object.as.cylinder.top;
    turned_over.object.as.cylinder.top = q->object.as.cylinder.base;
    case_answer expected = reference_answer_of(q);
    if (expected.status == SURE_INVALID)
        return;
    if (expected.status == SURE_HIT)
        expected.part = other_end(expected.part);
    expect_answer(&turned_over, &expected, "base and top exchanged");
}

START_TEST(test_ends)
{
    each_regime_case(SURE_SHAPE_CYLINDER, 10 * CASES, ends_exchange);
}
END_TEST

/* Two objects' hits are in the order of their rounded t, where these differ; an object ties with
 * itself, and a later t_min never makes a hit come sooner. */
static void order_is_consistent(const sure_case *q)
{
    static sure_case last;
    double t, other_t;
    int order = 77;
    if (reference_hit(&q->ray, &q->object, &t, NULL, NULL) != SURE_HIT)
        return;
    ck_assert_int_eq(reference_hit_order(&q->ray, &q->object, &q->object, &order), SURE_HIT);
    ck_assert_int_eq(order, 0);
    sure_object other = last.object;
    last = *q;
    if (reference_hit(&q->ray, &other, &other_t, NULL, NULL) != SURE_HIT)
        return;
    reference_hit_order(&q->ray, &q->object, &other, &order);
    if (t != other_t)
        ck_assert_int_eq(order, t < other_t ? -1 : 1);
    applied++;
}

START_TEST(test_order_laws)
{
    applied = 0;
    each_regime_case((sure_shape)_i, CASES, order_is_consistent);
    ck_assert_int_gt(applied, CASES / 4);
}
END_TEST

/* In a world of small integers every ray is walked in eighths: at each of these points a ray of
 * that one point must hit exactly where CGAL's kernel sees the boundary, have its chord exactly
 * where it sees the object, and nothing of the boundary comes before the hit. */
static void walk(const sure_case *q)
{
    sure_case stand = *q;
    sure_status hit = reference_hit(&q->ray, &q->object, NULL, NULL, NULL);
    if (hit == SURE_INVALID)
        return;
    for (int step = 0; step <= 40; step++) {
        double t = step / 8.0;
        int side = reference_where_at(&q->ray, &q->object, t);
        bool outside = q->object.shape == SURE_SHAPE_PLANE ? side != 0 : side > 0;
        stand.ray.t_min = stand.ray.t_max = t;
        ck_assert_msg((hit_between(q, t, t) == SURE_HIT) == (side == 0), "at %a: %s", t,
                      text_of(q));
        ck_assert_msg((reference_interval(&stand.ray, &q->object, NULL) == SURE_HIT) == !outside,
                      "at %a: %s", t, text_of(q));
        if (side == 0 && t >= q->ray.t_min && t <= q->ray.t_max) {
            ck_assert_int_eq(hit, SURE_HIT);
            ck_assert_int_le(sign_of_hit_minus(q, t), 0);
        }
    }
    applied += hit == SURE_HIT;
}

START_TEST(test_walks)
{
    uint64_t count = regime_integers_count((sure_shape)_i), taken = 600;
    applied = 0;
    for (uint64_t i = 0; i < taken; i++) {
        uint64_t index = i * (count / taken) + i;
        sure_case question = regime_case((sure_shape)_i, REGIME_INTEGERS, SEED, index);
        walk(&question);
    }
    ck_assert_int_gt(applied, 60);
}
END_TEST

static unsigned control_register(void)
{
#if defined(__SSE2__)
    return _mm_getcsr();
#else
    return (unsigned)fegetround();
#endif
}

/* Everything that can be asked of a case, and two angles. */
typedef struct {
    case_answer answer;
    sure_interval chord, by_kernel;
    sure_vec3 rotated;
    double extent;
    bool proved;
} everything;

static everything all_of(const sure_case *q)
{
    everything all = {.answer = reference_answer_of(q)};
    reference_interval(&q->ray, &q->object, &all.chord);
    if (q->object.shape <= SURE_SHAPE_SPHERE)
        reference_kernel_interval(&q->ray, &q->object, &all.by_kernel);
    all.rotated = reference_rotate(2, 1, (sure_vec3){1, 0x1p-1074, 0});
    all.extent = reference_viewport_extent(1, 60);
    all.proved = all.answer.status == SURE_INVALID || reference_certify(&q->ray, &q->object);
    return all;
}

static bool same_chord(const sure_interval *x, const sure_interval *y)
{
    return same_number(x->t_enter, y->t_enter) && same_number(x->t_leave, y->t_leave) &&
           x->enter_part == y->enter_part && x->leave_part == y->leave_part;
}

/* Answers, and the environment itself, are the same in every rounding mode and when the
 * processor takes subnormals for zeros. */
static void environment_does_not_matter(const sure_case *q)
{
    static const int numbers[] = {4, 1, 6, 3};
    everything expected = all_of(q);
    for (int i = 0; i < 4; i++) {
        surroundings_set(numbers[i] % SURROUNDINGS);
        unsigned before = control_register();
        everything is = all_of(q);
        unsigned after = control_register();
        surroundings_set(0);
        ck_assert_uint_eq(after, before);
        ck_assert_msg(same_answer(&is.answer, &expected.answer) &&
                          same_chord(&is.chord, &expected.chord) &&
                          same_chord(&is.by_kernel, &expected.by_kernel) && is.proved,
                      "rounding %s: %s", surroundings_name(numbers[i]), text_of(q));
        ck_vector_same(is.rotated, expected.rotated);
        ck_double_same(is.extent, expected.extent);
    }
}

START_TEST(test_environment)
{
    each_regime_case((sure_shape)_i, CASES / 6, environment_does_not_matter);
}
END_TEST

static void expect_hard_case(const hard_case *hard)
{
    expect_answer(&hard->question, &hard->answer, hard->text);
}

START_TEST(test_hard_case_files)
{
    const char *path = suite_file("cases/%s.cases", sure_shape_name((sure_shape)_i));
    ck_assert_int_gt(case_file_each(path, expect_hard_case), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("reference laws");
    add_looped(suite, "other routes", test_other_routes, SURE_SHAPES);
    add_looped(suite, "window", test_window, SURE_SHAPES);
    add_looped(suite, "axes", test_axes, SURE_SHAPES);
    add_looped(suite, "scales", test_scales, SURE_SHAPES);
    add_looped(suite, "moves", test_moves, SURE_SHAPES);
    add_looped(suite, "ends", test_ends, 1);
    add_looped(suite, "order laws", test_order_laws, SURE_SHAPES);
    add_looped(suite, "walks", test_walks, SURE_SHAPES);
    add_looped(suite, "environment", test_environment, SURE_SHAPES);
    add_looped(suite, "hard case files", test_hard_case_files, SURE_SHAPES);
    return suite_run(suite);
}
