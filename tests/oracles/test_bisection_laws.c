/* The laws of reference/bisection.h, by their numbers, bit for bit. */
#include "../support/bisection_result.h"
#include "../support/suite.h"

#include <math.h>

enum { O = 0, D = 3, T_MIN = 6, T_MAX = 7, ANCHOR = 8, SECOND = 11 };

static bool second_is_point(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

/* The index of the radius, or -1. */
static int radius_index(sure_shape shape)
{
    if (shape == SURE_SHAPE_PLANE)
        return -1;
    return shape == SURE_SHAPE_SPHERE ? 11 : 14;
}

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
    double numbers[CASE_NUMBERS_MAX];
    uint64_t stream = (uint64_t)shape * KINDS + (uint64_t)kind + 100;
    for (int i = 0; i < case_numbers(shape); i++)
        numbers[i] = random_number(kind, stream, index * CASE_NUMBERS_MAX + (uint64_t)i);
    if (radius_index(shape) >= 0)
        numbers[radius_index(shape)] = fabs(numbers[radius_index(shape)]);
    numbers[T_MIN] = index % 2 == 0 ? 0 : fabs(numbers[T_MIN]) / 4;
    numbers[T_MAX] = index % 3 == 0 ? INFINITY : numbers[T_MIN] + fabs(numbers[T_MAX]);
    return case_from_numbers(shape, numbers);
}

typedef void law(const sure_case *question, int kind, uint64_t index);

static void each_random_case(law *holds, uint64_t count)
{
    int hits = 0;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int kind = 0; kind < KINDS; kind++) {
            for (uint64_t i = 0; i < count; i++) {
                sure_case question = random_case((sure_shape)shape, kind, i);
                hits += bisection_of(&question).status == SURE_HIT;
                holds(&question, kind, i);
            }
        }
    }
    ck_assert_int_gt(hits, (int)count);
}

static void scale_numbers(double *numbers, int first, int count, int power)
{
    for (int i = first; i < first + count; i++)
        numbers[i] = ldexp(numbers[i], power);
}

static bisection_result scaled_t(const bisection_result *result, int power)
{
    bisection_result scaled = *result;
    scaled.t = ldexp(scaled.t, power);
    scaled.interval.t_enter = ldexp(scaled.interval.t_enter, power);
    scaled.interval.t_leave = ldexp(scaled.interval.t_leave, power);
    return scaled;
}

/* Law 1. */
static void scaling(const sure_case *question, int kind, uint64_t index)
{
    sure_shape shape = question->object.shape;
    int power = (int)(index % 3) * 400 - 400;
    double numbers[CASE_NUMBERS_MAX];
    (void)kind;
    case_to_numbers(question, numbers);
    scale_numbers(numbers, O, 3, power);
    scale_numbers(numbers, T_MIN, 2, power);
    scale_numbers(numbers, ANCHOR, 3, power);
    if (second_is_point(shape))
        scale_numbers(numbers, SECOND, 3, power);
    if (radius_index(shape) >= 0)
        scale_numbers(numbers, radius_index(shape), 1, power);
    sure_case scaled = case_from_numbers(shape, numbers);
    bisection_result before = bisection_of(question), got = bisection_of(&scaled);
    bisection_result expected = scaled_t(&before, power);
    bisection_expect(&scaled, &got, &expected, "lengths scaled");
}

/* Law 2. */
static void direction_scaling(const sure_case *question, int kind, uint64_t index)
{
    sure_shape shape = question->object.shape;
    int power = (int)(index % 5) * 150 - 300;
    double numbers[CASE_NUMBERS_MAX];
    (void)kind;
    case_to_numbers(question, numbers);
    scale_numbers(numbers, D, 3, power);
    scale_numbers(numbers, T_MIN, 2, -power);
    if (shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC)
        scale_numbers(numbers, SECOND, 3, power);
    sure_case scaled = case_from_numbers(shape, numbers);
    bisection_result before = bisection_of(question), got = bisection_of(&scaled);
    bisection_result expected = scaled_t(&before, -power);
    bisection_expect(&scaled, &got, &expected, "direction scaled");
}

/* x <- y <- z <- x */
static void turn(double *v)
{
    double x = v[0];
    v[0] = v[1];
    v[1] = v[2];
    v[2] = x;
}

/* Law 3. */
static void permutation(const sure_case *question, int kind, uint64_t index)
{
    sure_shape shape = question->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    (void)kind;
    (void)index;
    case_to_numbers(question, numbers);
    turn(numbers + O);
    turn(numbers + D);
    turn(numbers + ANCHOR);
    if (shape != SURE_SHAPE_SPHERE)
        turn(numbers + SECOND);
    sure_case turned = case_from_numbers(shape, numbers);
    bisection_result expected = bisection_of(question), got = bisection_of(&turned);
    sure_vec3 n = expected.normal;
    expected.normal = (sure_vec3){n.y, n.z, n.x};
    bisection_expect(&turned, &got, &expected, "axes permuted");
}

static void exchange(double *x, double *y)
{
    double kept = *x;
    *x = *y;
    *y = kept;
}

static double negated(double x)
{
    return x == 0 ? 0 : -x;
}

/* Law 3, x and y exchanged and z negated. */
static void reflection(const sure_case *question, int kind, uint64_t index)
{
    sure_shape shape = question->object.shape;
    static const int vectors[] = {O, D, ANCHOR, SECOND};
    double numbers[CASE_NUMBERS_MAX];
    (void)kind;
    (void)index;
    case_to_numbers(question, numbers);
    for (int i = 0; i < (shape == SURE_SHAPE_SPHERE ? 3 : 4); i++) {
        exchange(&numbers[vectors[i]], &numbers[vectors[i] + 1]);
        numbers[vectors[i] + 2] = -numbers[vectors[i] + 2];
    }
    sure_case mirrored = case_from_numbers(shape, numbers);
    bisection_result expected = bisection_of(question), got = bisection_of(&mirrored);
    sure_vec3 n = expected.normal;
    expected.normal = (sure_vec3){n.y, n.x, negated(n.z)};
    bisection_expect(&mirrored, &got, &expected, "mirrored");
}

/* Law 4: every coordinate of the grid moves exactly by integers up to 2^20. */
static void translation(const sure_case *question, int kind, uint64_t index)
{
    sure_shape shape = question->object.shape;
    double numbers[CASE_NUMBERS_MAX];
    if (kind == FULL)
        return;
    case_to_numbers(question, numbers);
    for (int i = 0; i < 3; i++) {
        int step = suite_integer(50, 3 * index + (uint64_t)i, 1 << 20);
        numbers[O + i] += step;
        numbers[ANCHOR + i] += step;
        if (second_is_point(shape))
            numbers[SECOND + i] += step;
    }
    sure_case moved = case_from_numbers(shape, numbers);
    bisection_result expected = bisection_of(question), got = bisection_of(&moved);
    bisection_expect(&moved, &got, &expected, "moved");
}

/* Law 5, for 3 d and an x of 50 bits, so that 3 x is exact. */
static void threefold_direction(const sure_case *question, int kind, uint64_t index)
{
    double numbers[CASE_NUMBERS_MAX];
    (void)index;
    if (kind == FULL)
        return;
    case_to_numbers(question, numbers);
    numbers[T_MIN] = 0;
    numbers[T_MAX] = INFINITY;
    sure_case plain = case_from_numbers(question->object.shape, numbers);
    for (int i = 0; i < 3; i++)
        numbers[D + i] *= 3;
    sure_case threefold = case_from_numbers(question->object.shape, numbers);
    bisection_result before = bisection_of(&plain), after = bisection_of(&threefold);
    ck_assert_int_eq(before.status, after.status);
    ck_assert_int_eq(before.part, after.part);
    ck_assert(bisection_same_vector(before.normal, after.normal));
    if (before.status != SURE_HIT)
        return;
    int exponent;
    double mantissa = frexp(after.t, &exponent);
    for (int step = -1; step <= 1; step++) {
        double x = ldexp(rint(ldexp(mantissa, 50)) + step, exponent - 50);
        ck_assert_int_eq(bisection_compare(&threefold.ray, &threefold.object, x),
                         bisection_compare(&plain.ray, &plain.object, 3 * x));
    }
}

/* Law 6. */
static void other_way_up(const sure_case *question, int kind, uint64_t index)
{
    static const sure_part other[] = {SURE_PART_SURFACE, SURE_PART_TOP, SURE_PART_BASE,
                                      SURE_PART_WALL};
    (void)kind;
    (void)index;
    if (question->object.shape != SURE_SHAPE_CYLINDER)
        return;
    sure_case turned = *question;
    turned.object.as.cylinder.base = question->object.as.cylinder.top;
    turned.object.as.cylinder.top = question->object.as.cylinder.base;
    bisection_result expected = bisection_of(question), got = bisection_of(&turned);
    expected.part = other[expected.part];
    expected.interval.enter_part = other[expected.interval.enter_part];
    expected.interval.leave_part = other[expected.interval.leave_part];
    bisection_expect(&turned, &got, &expected, "other way up");
}

/* Law 7. */
static void range_ends(const sure_case *question, int kind, uint64_t index)
{
    (void)kind;
    (void)index;
    bisection_result before = bisection_of(question);
    if (before.status != SURE_HIT)
        return;
    int side = bisection_compare(&question->ray, &question->object, before.t);
    sure_case cut = *question;
    cut.ray.t_max = before.t;
    if (cut.ray.t_max >= cut.ray.t_min)
        ck_assert_int_eq(bisection_of(&cut).status, side <= 0 ? SURE_HIT : SURE_MISS);
    cut = *question;
    cut.ray.t_min = before.t;
    if (side >= 0 && cut.ray.t_min <= cut.ray.t_max) {
        bisection_result after = bisection_of(&cut);
        bisection_expect(&cut, &after, &before, "t_min at the hit");
    }
}

/* Law 8. */
static void neighbours(const sure_case *question, int kind, uint64_t index)
{
    (void)kind;
    (void)index;
    bisection_result result = bisection_of(question);
    if (result.status != SURE_HIT)
        return;
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    ck_assert_int_eq(bisection_compare(ray, object, nextafter(result.t, INFINITY)), -1);
    ck_assert_int_eq(bisection_compare(ray, object, nextafter(result.t, -INFINITY)), 1);
    ck_assert_int_eq(bisection_compare(ray, object, INFINITY), -1);
    ck_assert_int_eq(bisection_compare(ray, object, -INFINITY), 1);
}

/* Law 9. */
static void order_of_pairs(const sure_case *question, int kind, uint64_t index)
{
    sure_shape other = (sure_shape)(index % SURE_SHAPES);
    sure_object second = random_case(other, kind, index + 1).object;
    const sure_ray *ray = &question->ray;
    const sure_object *first = &question->object;
    bisection_result x, y;
    if (bisection_answer(ray, first, &x) != SURE_HIT)
        return;
    ck_assert_int_eq(bisection_order(ray, first, first), 0);
    if (bisection_answer(ray, &second, &y) != SURE_HIT)
        return;
    int order = bisection_order(ray, first, &second);
    ck_assert_int_eq(bisection_order(ray, &second, first), -order);
    if (x.t != y.t)
        ck_assert_int_eq(order, x.t < y.t ? -1 : 1);
}

static law *const laws[] = {scaling,     direction_scaling,   permutation,  reflection,
                            translation, threefold_direction, other_way_up, range_ends,
                            neighbours,  order_of_pairs};

START_TEST(laws_hold)
{
    each_random_case(laws[_i], 600);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("bisection_laws");
    TCase *tcase = tcase_create("laws");
    tcase_set_timeout(tcase, 600);
    tcase_add_loop_test(tcase, laws_hold, 0, (int)(sizeof laws / sizeof laws[0]));
    suite_add_tcase(suite, tcase);
    return suite_run(suite);
}
