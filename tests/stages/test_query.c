/* SPDX-License-Identifier: MIT */
/* Is a scaled query the same query (src/stages/query.h)? By numbers' bits alone, with subnormals
 * kept and flushed. And ends next to a bound of the range. */
#include "../support/every_case.h"
#include "../support/objects.h"

#include "../../src/numbers/environment.h"
#include "../../src/stages/query.h"
#include "../../src/stages/rows.h"
#include "../../src/stages/stages.h"

enum {
    DRAWS = 4000,
    SEED = 25,
    LIMIT = 400,
    BOUNDS = 40,
    LARGER = 350,
    ENLARGED = 200,
    SIDES = 200
};

/* y = x 2^k, exactly? */
static bool is_shifted(double x, double y, int k)
{
    int from = 0, to = 0;
    bool same = bits_of(frexp(x, &from)) == bits_of(frexp(y, &to));
    return same && (x == 0 || to - from == k);
}

/* A t of a query: as it is, or, where that is beyond what any stage tells apart, as far out. */
static bool is_shifted_time(double t, double scaled, int k)
{
    if (isinf(t) || t == 0)
        return bits_of(t) == bits_of(scaled);
    int exponent = 0;
    (void)frexp(t, &exponent);
    if (abs(exponent + k) < LIMIT - 2)
        return is_shifted(t, scaled, k);
    return is_shifted(t, scaled, k) || scaled == power_of_two(exponent + k > 0 ? LIMIT : -LIMIT);
}

typedef struct {
    double least, most; /* of one number_kind of numbers, zeros apart */
} range;

static range range_of(sure_case c, number_kind of)
{
    range r = {INFINITY, 0};
    for (int i = 0; i < case_numbers(c.object.shape); i++) {
        double x = fabs(*case_number(&c, i));
        if (case_number_kind(c.object.shape, i) == of && x > 0) {
            r.least = fmin(r.least, x);
            r.most = fmax(r.most, x);
        }
    }
    return r;
}

static bool is_ordinary(range r)
{
    return r.most == 0 || (r.least >= 0x1p-30 && r.most <= 0x1p30);
}

/* Has the least of a kind more than the spread below the greatest, counted in binades? */
static bool is_spread(range r)
{
    return r.most > 0 && ilogb(r.least) - ilogb(r.most) < -QUERY_SPREAD;
}

typedef struct {
    query asked;
    bool in_range;
    long as_it_is, scaled, refused;
} watch;

static void ask(const sure_case *c, void *context)
{
    watch *w = context;
    w->in_range = query_of(&c->ray, row_of(&c->object), &c->object.as, &w->asked);
}

static int exponent_of_kind(range r)
{
    return r.most > 0 ? ilogb(r.most) : 0;
}

static void judge(const sure_case *c, void *context)
{
    watch *w = context;
    const query *q = &w->asked;
    sure_shape shape = c->object.shape;
    range lengths = range_of(*c, IS_LENGTH), steps = range_of(*c, IS_STEP),
          normals = range_of(*c, IS_NORMAL);
    bool ordinary = is_ordinary(lengths) && is_ordinary(steps) && is_ordinary(normals);
    bool spread = is_spread(lengths) || is_spread(steps) || is_spread(normals);
    case_require(c, w->in_range == (ordinary || !spread), "refused or not");
    w->refused += !w->in_range;
    if (!w->in_range)
        return;
    case_require(c, q->asked == &c->ray, "the ray asked");
    if (ordinary) {
        w->as_it_is++;
        case_require(c, q->ray == &c->ray && q->shape == &c->object.as, "scaled without need");
        case_require(c, q->t_exponent == 0 && q->length_exponent == 0, "exponents");
        return;
    }
    w->scaled++;
    sure_case from = *c, to = {.ray = *q->ray, .object.shape = shape};
    memcpy(&to.object.as, q->scaled_shape, sizeof q->scaled_shape);
    int unit = exponent_of_kind(lengths), step = exponent_of_kind(steps);
    int of_kind[] = {-unit, -step, step - unit, -exponent_of_kind(normals)};
    case_require(c, q->shape == q->scaled_shape, "another shape");
    case_require(c, q->length_exponent == unit && q->t_exponent == unit - step, "exponents");
    for (int i = 0; i < case_numbers(shape); i++) {
        number_kind of = case_number_kind(shape, i);
        double number = *case_number(&from, i), scaled = *case_number(&to, i);
        case_require(c, (of == IS_TIME ? is_shifted_time : is_shifted)(number, scaled, of_kind[of]),
                     "another number");
        case_require(c, of == IS_TIME || scaled == 0 || isnormal(scaled), "a subnormal");
    }
}

LOOP_TEST(test_regimes, SURE_SHAPES)
{
    watch w = {.in_range = false};
    in_each_regime((sure_shape)_i, ask, judge, &w);
    printf("%-8s as it is %ld, scaled %ld, refused %ld\n", sure_shape_name((sure_shape)_i),
           w.as_it_is, w.scaled, w.refused);
    ck_assert(w.as_it_is > DRAWS / 4 && w.scaled > DRAWS / 4 && w.refused > 0);
}

/* Numbers of all exponents, close together or apart by about the spread; zeros, subnormals. */
static double draw(int middle, int around, uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i);
    int exponent = middle + suite_integer(stream + 50, i, around);
    if (bits % 16 == 0)
        return bits % 32 ? 0.0 : -0.0;
    double x = ldexp(1 + (double)(bits >> 12) * 0x1p-52, exponent);
    return bits % 3 == 0 ? -x : x;
}

LOOP_TEST(test_draws, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    watch w = {.in_range = false};
    for (uint64_t i = 0; i < DRAWS; i++) {
        sure_case c = {.object.shape = shape};
        int middle[4], around = i % 3 ? 30 : 58;
        for (int k = 0; k < 4; k++)
            middle[k] = i % 5 ? suite_integer(10 + (uint64_t)k, i, 950) : -1040;
        for (int k = 0; k < case_numbers(shape); k++)
            *case_number(&c, k) =
                draw(middle[case_number_kind(shape, k)], around, 20 + (uint64_t)k, i);
        c.ray.t_min = fabs(c.ray.t_min);
        c.ray.t_max = i % 4 ? c.ray.t_min * 2 : INFINITY;
        object_mend(shape, case_number(&c, AT_OBJECT));
        if (case_is_valid(&c))
            in_each_environment(&c, ask, judge, &w);
    }
    printf("%-8s as it is %ld, scaled %ld, refused %ld\n", sure_shape_name(shape), w.as_it_is,
           w.scaled, w.refused);
    ck_assert(w.scaled > DRAWS && w.refused > DRAWS / 8);
}

/* Ranges that begin or end at an end of the chord, or next to it, and rays that start there: by all
 * stages what the last one says alone. */

typedef struct {
    sure_status status;
    sure_stage stage;
    sure_hit hit, certain;
    long asked, by_exact;
} bound_watch;

static void ask_bound(const sure_case *c, void *context)
{
    bound_watch *w = context;
    const void *shape = &c->object.as;
    w->status = stages_rest_of_hit(&c->ray, shape, &w->hit, row_of(&c->object), T_EXACT, &w->stage);
    if (sure_object_hit(&c->ray, &c->object, SURE_TIER_CERTAIN, &w->certain) != w->status)
        w->status = SURE_INVALID;
}

static bool is_same_end(const sure_hit *one, const sure_hit *two)
{
    return one->part == two->part && one->leaves == two->leaves;
}

static void judge_bound(const sure_case *c, void *context)
{
    bound_watch *w = context;
    sure_hit last = {0};
    sure_status status =
        stages_last_hit(row_of(&c->object), &c->ray, &c->object.as, T_EXACT, &last);
    const double t = w->certain.t;
    w->asked++;
    w->by_exact += w->stage == SURE_STAGE_EXACT;
    case_require(c, w->status == status, "another decision");
    if (status != SURE_HIT)
        return;
    case_require(c, is_same_end(&w->hit, &last) && is_same_end(&w->certain, &last), "another end");
    case_require(c, bits_of(w->hit.t) == bits_of(last.t) && w->hit.t_error == last.t_error,
                 "another t");
    case_require(c, t >= c->ray.t_min && t <= c->ray.t_max, "certain's t is out of the range");
    case_require(c, t == last.t || fabs(t - last.t) <= w->certain.t_error + last.t_error,
                 "certain's t is off");
}

static void ask_around(const sure_case *c, double t, uint64_t i, bound_watch *w)
{
    const double beyond = nextafter(t, INFINITY);
    /* A ray from the end's point, asked at once, from the next double on, or from a little later on
     * as renderers do: each a test's input. */
    const double starts[] = {0, 0x1p-1074, 0x1p-40 * t};
    const double ranges[][2] = {{t, INFINITY}, {0, t}, {t, t}, {t, beyond}};
    sure_case asked = *c;
    for (int k = 0; k < 4; k++) {
        asked.ray.t_min = ranges[k][0];
        asked.ray.t_max = ranges[k][1];
        if (case_is_valid(&asked))
            in_each_environment(&asked, ask_bound, judge_bound, w);
    }
    asked.ray = (sure_ray){plus(c->ray.origin, times(t, c->ray.direction)), c->ray.direction,
                           starts[i % 3], INFINITY};
    if (case_is_valid(&asked))
        in_each_environment(&asked, ask_bound, judge_bound, w);
}

SHAPE_TEST(test_bounds)
{
    bound_watch w = {.asked = 0};
    for (case_walk walk = walk_regimes((sure_shape)_i, SEED, BOUNDS); walk_next(&walk);) {
        sure_case c = walk.asked;
        sure_interval chord;
        c.ray.t_min = 0;
        c.ray.t_max = INFINITY;
        if (sure_object_interval(&c.ray, &c.object, SURE_TIER_EXACT, &chord) != SURE_HIT)
            continue;
        const double ends[] = {chord.t_enter, chord.t_leave};
        for (int e = 0; e < 2; e++) {
            for (int step = -1; step <= 1 && ends[e] > 0 && isfinite(ends[e]); step++)
                ask_around(&c, step == 0 ? ends[e] : nextafter(ends[e], step * (double)INFINITY),
                           walk.index, &w);
        }
    }
    printf("%-8s %ld around an end, exact %.1f %%\n", sure_shape_name((sure_shape)_i), w.asked,
           100. * (double)w.by_exact / (double)w.asked);
    ck_assert_int_gt(w.asked, 100 * BOUNDS);
}

/* On which side the start is: as exact numbers say, or not known. */

typedef struct {
    bool known;
    int side;
    sure_stage stage;
    long asked, on, on_by_bits;
} side_watch;

static void ask_side(const sure_case *c, void *context)
{
    side_watch *w = context;
    w->stage = SURE_STAGE_DOUBLE_DOUBLE;
    TO_NEAREST(w->known,
               query_side(row_of(&c->object), &c->object.as, c->ray.origin, &w->side, &w->stage));
}

static void judge_side(const sure_case *c, void *context)
{
    side_watch *w = context;
    int side = query_side_exact(row_of(&c->object), &c->object.as, c->ray.origin);
    case_require(c, !w->known || w->side == side, "another side");
    w->asked++;
    w->on += side == 0;
    w->on_by_bits += side == 0 && w->known;
}

SHAPE_TEST(test_side)
{
    side_watch w = {.known = false};
    for (case_walk walk = walk_regimes((sure_shape)_i, SEED, SIDES); walk_next(&walk);)
        in_each_environment(&walk.asked, ask_side, judge_side, &w);
    printf("%-8s %ld starts, on the surface %ld, of which known %ld\n",
           sure_shape_name((sure_shape)_i), w.asked, w.on, w.on_by_bits);
    ck_assert_int_gt(w.on, SIDES);
    ck_assert_int_gt(2 * w.on_by_bits, w.on);
}

/* What numbers of a kind are multiplied by, as exponents of 2. */
typedef int change[NUMBER_KINDS];

/* Exactly; false where they are none then. */
static bool enlarge(const sure_case *c, const change by, sure_case *larger)
{
    *larger = *c;
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        double *number = case_number(larger, i), before = *number;
        const int exponent = by[case_number_kind(c->object.shape, i)];
        *number = ldexp(before, exponent);
        if (isinf(*number) != isinf(before) || ldexp(*number, -exponent) != before)
            return false;
    }
    return true;
}

static bool is_last(const sure_case *c)
{
    return sure_object_stage(&c->ray, &c->object, SURE_TIER_CERTAIN) == SURE_STAGE_EXACT;
}

static const change changes[] = {
    {[IS_LENGTH] = LARGER, [IS_TIME] = LARGER},
    {[IS_STEP] = LARGER, [IS_TIME] = -LARGER},
    {[IS_STEP] = -LARGER, [IS_TIME] = LARGER},
    {[IS_LENGTH] = LARGER, [IS_STEP] = LARGER, [IS_NORMAL] = LARGER},
    {[IS_NORMAL] = -LARGER},
};

/* Larger or smaller than the first stage takes: the same answer, and t as good, but where either is
 * left to the last stage, since its numbers lie too far apart. (At the limits of a stage's range,
 * where few cases are, another one may tell, with another t.) */
SHAPE_TEST(test_enlarged)
{
    long asked = 0;
    for (case_walk walk = walk_regimes((sure_shape)_i, SEED, ENLARGED); walk_next(&walk);) {
        sure_case larger;
        sure_hit hit = {0}, again = {0};
        const sure_case *c = &walk.asked;
        const int *by = changes[walk.index % (sizeof changes / sizeof *changes)];
        if (!enlarge(c, by, &larger) || is_last(c) || is_last(&larger))
            continue;
        sure_status status = sure_object_hit(&c->ray, &c->object, SURE_TIER_CERTAIN, &hit);
        bool same =
            sure_object_hit(&larger.ray, &larger.object, SURE_TIER_CERTAIN, &again) == status &&
            is_same_end(&hit, &again);
        case_require(c, same, "another decision");
        case_require(c, ldexp(hit.t, by[IS_TIME]) == again.t, "another t");
        /* Beside it the first has a floor, which is less than the rest. */
        double error = ldexp(hit.t_error, by[IS_TIME]);
        case_require(c, error >= again.t_error && error <= 2 * again.t_error, "another error");
        asked++;
    }
    ck_assert_int_gt(asked, 10 * ENLARGED);
}

/* The way back: exactly, or not at all. */
TEST(test_shift)
{
    long shifted = 0;
    for (uint64_t i = 0; i < 10 * DRAWS; i++) {
        double x = double_of(suite_bits(70, i)), y;
        int k = suite_integer(71, i, 2100);
        if (!query_shift(x, k, &y))
            continue;
        ck_assert(isfinite(x));
        shifted++;
        if (!is_shifted(x, y, k))
            ck_abort_msg("%a 2^%d is not %a", x, k, y);
    }
    ck_assert_int_gt(shifted, DRAWS);
}

SUITE("query")
