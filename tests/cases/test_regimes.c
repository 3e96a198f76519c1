/* SPDX-License-Identifier: MIT */
/* The named generators: pure, unchanging, valid, of both outcomes, and as hard as their names say.
 * What they claim is checked in exact integers (line_signs.h) and against the bisection oracle. */

#include "../../reference/bisection.h"
#include "every_case.h"
#include "line_signs.h"
#include "objects.h"

/* What a shape is, by its fields and parts. */
static bool has_part(sure_shape shape, sure_part part)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    bool found = false;
    for (int i = 0; i < info->part_count; i++)
        found = found || info->parts[i] == part;
    return found;
}

static bool is_round(sure_shape shape)
{
    return shape_has(shape, SURE_KIND_RADIUS);
}

static bool is_flat(sure_shape shape)
{
    return shape_has(shape, SURE_KIND_NORMAL);
}

static bool is_capped(sure_shape shape)
{
    return is_round(shape) && has_part(shape, SURE_PART_BASE);
}

/* Of these line_signs.h tells where a line runs. */
static bool has_signs(sure_shape shape)
{
    return is_round(shape) || is_flat(shape);
}

#define PAIRS (REGIMES * SURE_SHAPES)
#define SEED 1

enum { COUNT = 1000, AT_SECOND = AT_OBJECT + 3 };

/* Loop tests run once a pair: _i is its number. */
static regime regime_of(int pair)
{
    return (regime)(pair / SURE_SHAPES);
}

static sure_shape shape_of(int pair)
{
    return (sure_shape)(pair % SURE_SHAPES);
}

static bool applies(int pair)
{
    return regime_applies(shape_of(pair), regime_of(pair)) != 0;
}

static sure_case made(int pair, uint64_t index)
{
    return regime_case(shape_of(pair), regime_of(pair), SEED, index);
}

TEST(test_names)
{
    for (int i = 0; i < REGIMES; i++) {
        regime found = REGIMES;
        ck_assert_int_eq(regime_from_name(regime_name((regime)i), &found), 1);
        ck_assert_int_eq(found, i);
    }
    regime untouched = REGIME_COIN;
    ck_assert_int_eq(regime_from_name("typica", &untouched), 0);
    ck_assert_int_eq(regime_from_name("typicall", &untouched), 0);
    ck_assert_int_eq(regime_from_name("", &untouched), 0);
    ck_assert_int_eq(untouched, REGIME_COIN);
    ck_assert_ptr_null(regime_name(REGIMES));
    ck_assert_ptr_null(regime_name((regime)-1));
}

TEST(test_applies)
{
    ck_assert_int_eq(regime_applies(SURE_SHAPES, REGIME_TYPICAL), 0);
    ck_assert_int_eq(regime_applies(SURE_SHAPE_CONE, REGIMES), 0);
}

/* The bits of a case, with one NaN for all. */
static void to_bits(const sure_case *question, uint64_t bits[CASE_NUMBERS_MAX])
{
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(question, number);
    memset(bits, 0, CASE_NUMBERS_MAX * sizeof *bits);
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        memcpy(&bits[i], &number[i], sizeof *bits);
        if (isnan(number[i]))
            bits[i] = UINT64_C(0x7ff8000000000000);
    }
}

static bool same(const sure_case *x, const sure_case *y)
{
    uint64_t a[CASE_NUMBERS_MAX], b[CASE_NUMBERS_MAX];
    to_bits(x, a);
    to_bits(y, b);
    return x->object.shape == y->object.shape && memcmp(a, b, sizeof a) == 0;
}

LOOP_TEST(test_pure, PAIRS)
{
    if (!applies(_i))
        return;
    enum { FIRST = 100 };
    sure_case forwards[FIRST];
    for (uint64_t i = 0; i < FIRST; i++)
        forwards[i] = made(_i, i);
    int like_first = 0, like_other = 0;
    for (uint64_t i = FIRST; i-- > 0;) {
        sure_case again = made(_i, i);
        /* No bit of seed or index is ignored. */
        uint64_t seed = SEED ^ UINT64_C(1) << (i % 64);
        sure_case other_seed = regime_case(shape_of(_i), regime_of(_i), seed, i);
        sure_case other_index = made(_i, i ^ UINT64_C(1) << (i % 63 + 1));
        ck_assert_msg(same(&again, &forwards[i]), "case %" PRIu64 ": %s", i, case_text(&again));
        ck_assert_int_eq(again.object.shape, shape_of(_i));
        like_first += same(&again, &forwards[0]);
        like_other += same(&again, &other_seed) + same(&again, &other_index);
    }
    ck_assert_int_eq(like_first, 1);
    ck_assert_int_eq(like_other, 0);
    /* The far end of the numbers has cases, too. */
    sure_case last = regime_case(shape_of(_i), regime_of(_i), UINT64_MAX, UINT64_MAX);
    ck_assert_int_eq(last.object.shape, shape_of(_i));
}

/* The tally of the first cases, by the oracle. */
typedef struct {
    int asked, hit, miss, invalid, inside;
    bool field_seen[SURE_FIELD_RADIUS + 1];
} tally;

static bool starts_inside(const sure_case *valid)
{
    sure_shape shape = valid->object.shape;
    if (!sure_shape_info_of(shape)->solid || !has_signs(shape))
        return false;
    point_signs at = point_signs_at(valid, 0, 0);
    return at.round < 0 && (!is_capped(shape) || (at.height > 0 && at.over_end < 0));
}

static tally tally_of(int pair, int asked)
{
    tally count = {.asked = asked};
    for (int i = 0; i < count.asked; i++) {
        sure_case c = made(pair, (uint64_t)i);
        bisection_result truth;
        sure_status status = bisection_answer(&c.ray, &c.object, &truth);
        count.hit += status == SURE_HIT;
        count.miss += status == SURE_MISS;
        count.invalid += status == SURE_INVALID;
        count.field_seen[truth.field] = true;
        if (status != SURE_INVALID)
            count.inside += starts_inside(&c);
    }
    return count;
}

/* A fifth hit and a fifth miss; invalid are only those that are meant to be. */
LOOP_TEST(test_shares, PAIRS)
{
    if (!applies(_i))
        return;
    tally count = tally_of(_i, 300);
    ck_assert_msg(5 * count.hit >= count.asked && 5 * count.miss >= count.asked,
                  "%s of %s: %d hit, %d miss, %d invalid", regime_name(regime_of(_i)),
                  sure_shape_name(shape_of(_i)), count.hit, count.miss, count.invalid);
    if (regime_of(_i) == REGIME_DEGENERATE)
        ck_assert(5 * count.invalid >= count.asked);
    else if (regime_of(_i) == REGIME_BITS)
        ck_assert(count.invalid > 0 && 10 * count.invalid < count.asked);
    else
        ck_assert_int_eq(count.invalid, 0);
}

/* Half hit, a tenth from inside: to a twentieth and a fortieth of the cases. */
LOOP_TEST(test_typical, SURE_SHAPES)
{
    tally count = tally_of(REGIME_TYPICAL * SURE_SHAPES + _i, 2000);
    ck_assert_int_le(abs(2 * count.hit - count.asked), count.asked / 10);
    if (sure_shape_info_of((sure_shape)_i)->solid && has_signs((sure_shape)_i))
        ck_assert_int_le(abs(10 * count.inside - count.asked), count.asked / 4);
}

/* Every field of the shape is at fault at times, each of the others never. */
LOOP_TEST(test_degenerate_fields, SURE_SHAPES)
{
    const sure_shape_info *info = sure_shape_info_of((sure_shape)_i);
    tally count = tally_of(REGIME_DEGENERATE * SURE_SHAPES + _i, 500);
    for (int field = SURE_FIELD_NONE; field <= SURE_FIELD_RADIUS; field++) {
        bool expected = field <= SURE_FIELD_T_MAX;
        for (int k = 0; k < info->field_count; k++)
            expected = expected || (int)info->fields[k].name == field;
        ck_assert_msg(count.field_seen[field] == expected, "%s",
                      sure_field_name((sure_field)field));
    }
}

/* Is the line exactly what the regime is named after? */
static bool exactly(regime which, const sure_case *c)
{
    line_signs line = line_signs_of(c);
    point_signs start = point_signs_at(c, 0, 0);
    sure_shape shape = c->object.shape;
    bool top = has_part(shape, SURE_PART_TOP);
    bool in_cap = start.height == 0 || (top && start.over_end == 0);
    switch (which) {
    case REGIME_TANGENT:
        if (is_flat(shape) && (line.slope != 0 || (is_round(shape) && start.height != 0)))
            return false;
        return !is_round(shape) || (line.a > 0 && line.discriminant == 0);
    case REGIME_ON_SURFACE:
        if (is_flat(shape))
            return start.height == 0 && (!is_round(shape) || start.round <= 0);
        if (!is_capped(shape))
            return start.round == 0;
        return start.height >= 0 && start.over_end <= 0 && start.round <= 0 &&
               (start.round == 0 || in_cap);
    case REGIME_RIM: return line.meets_base_rim || (top && line.meets_end_rim);
    case REGIME_APEX: return line.meets_apex;
    case REGIME_AXIS_PARALLEL: return line.along_axis;
    case REGIME_WALL_PARALLEL: return line.a == 0;
    case REGIME_FAR_TANGENT:
    case REGIME_SCALED_NEIGHBOUR: return exactly(REGIME_TANGENT, c) || exactly(REGIME_RIM, c);
    case REGIME_EDGE_ON: return line.slope == 0 && in_cap;
    case REGIME_INSIDE: return starts_inside(c);
    default: return false;
    }
}

/* One of the first few numbers moved by some ulps makes it exact, and few cases are so already. (A
 * step along the ray leads to no tangent, and one along a plane not off it.) */
static const struct {
    regime which, exact;
    int numbers, ulps, cases;
} beside[] = {{REGIME_NEIGHBOUR, REGIME_TANGENT, CASE_NUMBERS_MAX, 4, 100},
              {REGIME_OFF_SURFACE, REGIME_ON_SURFACE, 3, 1, 300}};

static bool exact_when_moved(regime exact, const sure_case *c, int which, int steps)
{
    sure_case moved = *c;
    double *number = case_number(&moved, which);
    *number = step_ulps(*number, steps);
    return exactly(exact, &moved);
}

LOOP_TEST(test_beside, 2 * SURE_SHAPES)
{
    sure_shape shape = (sure_shape)(_i / 2);
    int already = 0, numbers = beside[_i % 2].numbers, ulps = beside[_i % 2].ulps;
    regime exact = beside[_i % 2].exact;
    for (uint64_t i = 0; has_signs(shape) && i < (uint64_t)beside[_i % 2].cases; i++) {
        sure_case c = regime_case(shape, beside[_i % 2].which, SEED, i);
        bool found = exactly(exact, &c);
        already += found && (is_round(shape) || point_signs_at(&c, 0, 0).height == 0);
        for (int k = 0; k < numbers && k < case_numbers(shape) && !found; k++)
            for (int steps = -ulps; steps <= ulps && !found; steps++)
                found = k != 6 && k != 7 && exact_when_moved(exact, &c, k, steps);
        ck_assert_msg(found, "%s", case_text(&c));
    }
    ck_assert_msg(2 * already <= beside[_i % 2].cases, "%d", already);
}

static double length(sure_vec3 v)
{
    return hypot(hypot(v.x, v.y), v.z);
}

static double largest(const double *number, int count)
{
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(number[i]));
    return most;
}

static bool is_ball(sure_shape shape)
{
    return is_round(shape) && !is_flat(shape) && !is_capped(shape);
}

static bool has_other(sure_shape shape)
{
    return is_flat(shape) || is_capped(shape);
}

/* What is measured of the numbers of a case. */

static double radius_of(const double *x, sure_shape shape)
{
    return x[case_numbers(shape) - 1];
}

/* From the object's first point to the start of the ray. */
static sure_vec3 way_of(const double *x)
{
    return minus(vector_of(x), vector_of(x + AT_OBJECT));
}

/* The normal, or the axis. */
static sure_vec3 axis_of(const double *x, sure_shape shape)
{
    sure_vec3 second = vector_of(x + AT_SECOND);
    return is_flat(shape) ? second : minus(second, vector_of(x + AT_OBJECT));
}

static double radii_away(const double *x, sure_shape shape)
{
    return length(way_of(x)) / radius_of(x, shape);
}

static double slenderness(const double *x, sure_shape shape)
{
    return length(axis_of(x, shape)) / radius_of(x, shape);
}

/* Of the ray against a flat face, or against the axis. */
static double slope(const double *x, sure_shape shape)
{
    sure_vec3 d = vector_of(x + AT_D), n = axis_of(x, shape);
    double along = fabs(dot(d, n)), across = length(cross(d, n));
    return is_flat(shape) ? along / across : across / along;
}

/* Of the impact parameter over the radius from 1. */
static double off_edge(const double *x, sure_shape shape)
{
    sure_vec3 d = vector_of(x + AT_D);
    return fabs(length(cross(way_of(x), d)) / length(d) / radius_of(x, shape) - 1);
}

/* Of the ray's start and the object's first point; and of the number behind that. */
static double place(const double *x, sure_shape shape)
{
    (void)shape;
    return fmax(largest(x, 3), largest(x + AT_OBJECT, 3));
}

static double size(const double *x, sure_shape shape)
{
    return fmax(largest(x, 3), largest(x + AT_OBJECT, is_flat(shape) ? 3 : 4));
}

static double size_exponent(const double *x, sure_shape shape)
{
    return log2(is_ball(shape) ? size(x, shape) : place(x, shape));
}

static double d_exponent(const double *x, sure_shape shape)
{
    (void)shape;
    return fabs(log2(length(vector_of(x + AT_D))));
}

static double other_exponent(const double *x, sure_shape shape)
{
    return fabs(log2(length(axis_of(x, shape))));
}

static double any_exponent(const double *x, sure_shape shape)
{
    double d = d_exponent(x, shape);
    return has_other(shape) ? fmax(d, other_exponent(x, shape)) : d;
}

/* Of 1000 cases, of all shapes or of some, so many are measured to be between low and high; without
 * a measure, 1 is what is exactly as the regime says. */
static const struct {
    regime which;
    double (*measure)(const double *x, sure_shape shape);
    bool (*of)(sure_shape shape);
    double low, high;
    int least, most;
} claims[] = {
    /* What is built in whole numbers has not been rounded: all of it, or the half or third that is
     * not moved on purpose. What is moved along the ray, or along a plane, is as exact as before;
     * from afar a plane is crossed. */
    {REGIME_TANGENT, NULL, has_signs, 0, 2, COUNT, COUNT},
    {REGIME_ON_SURFACE, NULL, has_signs, 0, 2, COUNT, COUNT},
    {REGIME_RIM, NULL, has_signs, 0, 2, 450, 800},
    {REGIME_APEX, NULL, has_signs, 0, 2, 450, 800},
    {REGIME_AXIS_PARALLEL, NULL, has_signs, 0, 2, 283, 633},
    {REGIME_WALL_PARALLEL, NULL, has_signs, 0, 2, 283, 633},
    {REGIME_EDGE_ON, NULL, has_signs, 0, 2, 283, 633},
    {REGIME_FAR_TANGENT, NULL, is_round, 0, 2, 450, 800},
    {REGIME_SCALED_NEIGHBOUR, NULL, has_signs, 0, 2, 450, COUNT},
    {REGIME_SCALED_NEIGHBOUR, NULL, is_round, 0, 2, 450, 800},
    {REGIME_INSIDE, NULL, has_signs, 0, 2, COUNT, COUNT},
    {REGIME_FAR, radii_away, is_round, 0x1p9, 0x1p51, COUNT, COUNT},
    {REGIME_FAR, radii_away, is_round, 0x1p49, 0x1p51, 1, COUNT},
    {REGIME_FAR_TANGENT, radii_away, is_round, 0x1p5, 0x1p47, COUNT, COUNT},
    {REGIME_FAR_TANGENT, radii_away, is_round, 0x1p40, 0x1p47, 1, COUNT},
    {REGIME_NEARLY_PARALLEL, slope, has_signs, 0x1p-31, 0x1p-19, COUNT, COUNT},
    {REGIME_NEARLY_PARALLEL, slope, has_signs, 0x1p-21, 0x1p-19, 1, COUNT},
    {REGIME_NEEDLE, slenderness, is_capped, 0x1p37, 0x1p43, COUNT, COUNT},
    {REGIME_NEEDLE, slenderness, is_capped, 0x1p41, 0x1p43, 1, COUNT},
    {REGIME_COIN, slenderness, is_capped, 0x1p-43, 0x1p-37, COUNT, COUNT},
    {REGIME_COIN, slenderness, is_capped, 0x1p-39, 0x1p-37, 1, COUNT},
    {REGIME_GRAZING, off_edge, is_ball, -1, 0x1p-5, COUNT, COUNT},
    {REGIME_GRAZING, off_edge, is_ball, -1, 0x1p-16, 501, COUNT},
    /* Squares overflow, where a ray does not start at the origin, in a plane's point; or
     * underflow. */
    {REGIME_HUGE, place, NULL, -1, 0x1p997, COUNT, COUNT},
    {REGIME_HUGE, place, NULL, 0, 0x1p510, 0, 0},
    {REGIME_HUGE, place, is_round, 0x1.fffffffffffffp509, 0x1p997, COUNT, COUNT},
    {REGIME_TINY, size, NULL, -1, 0x1p-511, COUNT, COUNT},
    {REGIME_TINY, size, NULL, 0, DBL_MIN, 1, COUNT},
    /* The same, and no length is near the subnormals. */
    {REGIME_SCALED_NEIGHBOUR, size_exponent, NULL, -1000, 997, COUNT, COUNT},
    {REGIME_SCALED_NEIGHBOUR, size_exponent, NULL, -691, 601, 0, 0},
    {REGIME_SCALED_NEIGHBOUR, size_exponent, NULL, 600, 997, 401, 599},
    /* |d|, or the normal or axis, is far from 1. */
    {REGIME_NONUNIT, any_exponent, NULL, 250, INFINITY, COUNT, COUNT},
    {REGIME_NONUNIT, d_exponent, NULL, 250, INFINITY, 501, COUNT},
    {REGIME_NONUNIT, other_exponent, has_other, 250, INFINITY, 251, COUNT},
    /* A third is exactly across, but for those moved by ulps; sizes and ways are far apart. */
    {REGIME_SCALES, slope, is_flat, -1, 0x1p-60, 250, 400},
    {REGIME_SCALES, radii_away, is_ball, 0x1p60, INFINITY, 10, COUNT},
    {REGIME_SCALES, slenderness, is_capped, 0, 0x1p-40, 10, COUNT},
    {REGIME_SCALES, slenderness, is_capped, 0x1p10, INFINITY, 10, COUNT},
};

LOOP_TEST(test_claims, (int)(sizeof claims / sizeof *claims))
{
    regime which = claims[_i].which;
    int shapes = 0;
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        int found = 0;
        if (!regime_applies(shape, which) || (claims[_i].of && !claims[_i].of(shape)))
            continue;
        shapes++;
        for (uint64_t i = 0; i < COUNT; i++) {
            sure_case c = regime_case(shape, which, SEED, i);
            double x[CASE_NUMBERS_MAX];
            case_to_numbers(&c, x);
            double measure = claims[_i].measure ? claims[_i].measure(x, shape) : exactly(which, &c);
            found += measure > claims[_i].low && measure < claims[_i].high;
        }
        ck_assert_msg(found >= claims[_i].least && found <= claims[_i].most,
                      "%s of %s: %d between %g and %g", regime_name(which), sure_shape_name(shape),
                      found, claims[_i].low, claims[_i].high);
    }
    ck_assert_int_gt(shapes, 0);
}

/* There is a boundary point within five ulps of an end of the range, and in half of cases within
 * one. */
LOOP_TEST(test_interval, SURE_SHAPES)
{
    enum { ASKED = 500 };
    int near = 0, nearest = 0;
    for (uint64_t i = 0; i < ASKED; i++) {
        sure_case c = made(REGIME_INTERVAL * SURE_SHAPES + _i, i);
        double end = isinf(c.ray.t_max) ? c.ray.t_min : c.ray.t_max;
        bisection_result truth;
        c.ray.t_min = step_ulps(end, -5);
        c.ray.t_max = step_ulps(end, 5);
        near += bisection_answer(&c.ray, &c.object, &truth) == SURE_HIT;
        c.ray.t_min = step_ulps(end, -1);
        c.ray.t_max = step_ulps(end, 1);
        nearest += bisection_answer(&c.ray, &c.object, &truth) == SURE_HIT;
    }
    ck_assert_msg(near == ASKED && 2 * nearest > ASKED, "%d, %d of %d", near, nearest, ASKED);
}

/* The two midpoints next to t >= 0 (of infinity the one that rounds to it), as m 2^exponent. */
typedef struct {
    int64_t m[2];
    int exponent;
} midpoints;

static midpoints midpoints_next_to(double t)
{
    if (isinf(t))
        return (midpoints){{(INT64_C(1) << 54) - 1, (INT64_C(1) << 54) - 1}, 970};
    int e;
    double mantissa = frexp(t, &e);
    int unit = t < DBL_MIN ? -1074 : e - 53;
    int64_t twice = 2 * (int64_t)ldexp(mantissa, e - unit);
    return (midpoints){{twice - 1, twice + 1}, unit - 1};
}

/* Is the point at a midpoint next to t exactly on the boundary, up to the extent of its parts? */
static bool at_midpoint(const sure_case *c, double t)
{
    sure_shape shape = c->object.shape;
    midpoints next = midpoints_next_to(t);
    for (int i = 0; i < 2; i++) {
        point_signs at = point_signs_at(c, next.m[i], next.exponent);
        bool cap = at.height == 0 || (has_part(shape, SURE_PART_TOP) && at.over_end == 0);
        if ((!is_flat(shape) && at.round == 0) || (cap && (is_flat(shape) || is_capped(shape))))
            return true;
    }
    return false;
}

/* Of the hits of the whole ray half are exactly halfway between two doubles; all kinds of doubles
 * occur. */
LOOP_TEST(test_midpoint, SURE_SHAPES)
{
    if (!has_signs((sure_shape)_i))
        return;
    int hits = 0, halfway = 0, subnormal = 0, normal = 0, overflow = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        sure_case c = made(REGIME_MIDPOINT * SURE_SHAPES + _i, i);
        bisection_result truth;
        c.ray.t_min = 0;
        c.ray.t_max = INFINITY;
        if (bisection_answer(&c.ray, &c.object, &truth) != SURE_HIT)
            continue;
        hits++;
        if (!at_midpoint(&c, truth.t))
            continue;
        halfway++;
        subnormal += truth.t < DBL_MIN;
        overflow += isinf(truth.t);
        normal += truth.t >= DBL_MIN && !isinf(truth.t);
    }
    ck_assert_msg(hits > 700 && 5 * halfway > 2 * hits && 5 * halfway < 4 * hits, "%d of %d",
                  halfway, hits);
    ck_assert(subnormal > 50 && overflow > 20 && normal > 200);
}

static int by_value(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* The first cases of the world, or all of them, differ in pairs; behind its end it begins again. */
LOOP_TEST(test_integers, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    uint64_t all = regime_integers_count(shape);
    uint64_t count = all < 2000000 ? all : 300000;
    uint64_t *code = malloc(count * sizeof *code);
    ck_assert_ptr_nonnull(code);
    for (uint64_t i = 0; i < count; i++) {
        sure_case c = made(REGIME_INTEGERS * SURE_SHAPES + _i, i);
        code[i] = 0;
        for (int k = 0; k < case_numbers(shape); k++) {
            /* -3 .. 3, and infinity as 4. */
            double number = *case_number(&c, k);
            int digit = isinf(number) ? 4 : (int)number;
            if (digit < -3 || !(digit == number || k == AT_T_MAX))
                ck_abort_msg("number %d: %a", k, number);
            code[i] = code[i] * 8 + (uint64_t)(digit + 3);
        }
    }
    qsort(code, count, sizeof *code, by_value);
    for (uint64_t i = 1; i < count; i++)
        if (code[i - 1] == code[i])
            ck_abort_msg("twice: %" PRIo64, code[i]);
    free(code);
    sure_case first = regime_case(shape, REGIME_INTEGERS, SEED, 0);
    sure_case again = regime_case(shape, REGIME_INTEGERS, SEED, all);
    ck_assert(same(&first, &again));
}

/* All numbers but the range take every class of exponent and mantissa. */
LOOP_TEST(test_bits, SURE_SHAPES)
{
    for (int k = 0; k < case_numbers((sure_shape)_i); k++) {
        int zero = 0, subnormal = 0, power = 0, ones = 0, huge = 0, one = 0;
        for (uint64_t i = 0; i < COUNT; i++) {
            sure_case c = made(REGIME_BITS * SURE_SHAPES + _i, i);
            int e;
            double x = fabs(*case_number(&c, k)), mantissa = frexp(x, &e);
            zero += x == 0;
            subnormal += x > 0 && x < DBL_MIN;
            power += mantissa == 0.5;
            ones += mantissa == 1 - DBL_EPSILON / 2;
            huge += isfinite(x) && x > 0x1p1000;
            one += x > 0x1p-8 && x < 0x1p8;
        }
        bool in_range = k == 6 || k == 7;
        ck_assert_msg((zero || k == 7) && subnormal && power && (50 * ones > COUNT || in_range) &&
                          huge && one,
                      "number %d", k);
    }
}

SUITE("regimes")
