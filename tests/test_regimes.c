/* The named generators: pure, unchanging, valid, of both outcomes, and as hard as their names say. What they
 * claim is checked in exact integers (line_signs.h) and against the bisection oracle. */
#include "suite.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../reference/bisection.h"
#include "../src/judge/regimes.h"
#include "line_signs.h"

/* As regime_applies should have it. */
static const char *const applies_to[REGIMES] = {
    [REGIME_TYPICAL] = "plane disc sphere cylinder cone",
    [REGIME_GRAZING] = "plane disc sphere cylinder cone",
    [REGIME_TANGENT] = "plane disc sphere cylinder cone",
    [REGIME_NEIGHBOUR] = "plane disc sphere cylinder cone",
    [REGIME_FAR] = "plane disc sphere cylinder cone",
    [REGIME_HUGE] = "plane disc sphere cylinder cone",
    [REGIME_TINY] = "plane disc sphere cylinder cone",
    [REGIME_INSIDE] = "sphere cylinder cone",
    [REGIME_ON_SURFACE] = "plane disc sphere cylinder cone",
    [REGIME_RIM] = "disc cylinder cone",
    [REGIME_APEX] = "cone",
    [REGIME_AXIS_PARALLEL] = "cylinder cone",
    [REGIME_WALL_PARALLEL] = "cone",
    [REGIME_EDGE_ON] = "disc cylinder cone",
    [REGIME_NEEDLE] = "cylinder cone",
    [REGIME_COIN] = "cylinder cone",
    [REGIME_DEGENERATE] = "plane disc sphere cylinder cone",
    [REGIME_INTERVAL] = "plane disc sphere cylinder cone",
    [REGIME_MIDPOINT] = "plane disc sphere cylinder cone",
    [REGIME_NONUNIT] = "plane disc sphere cylinder cone",
    [REGIME_INTEGERS] = "plane disc sphere cylinder cone",
    [REGIME_BITS] = "plane disc sphere cylinder cone",
};

#define PAIRS (REGIMES * SURE_SHAPES)
#define SEED 1

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

static const char *shown(const sure_case *question)
{
    static char line[CASE_LINE_MAX];
    case_print(question, line);
    return line;
}

START_TEST(test_names)
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
END_TEST

START_TEST(test_applies)
{
    for (int pair = 0; pair < PAIRS; pair++) {
        const char *shapes = applies_to[regime_of(pair)];
        bool expected = strstr(shapes, sure_shape_name(shape_of(pair))) != NULL;
        ck_assert_msg(applies(pair) == expected, "%s of %s", regime_name(regime_of(pair)),
                      sure_shape_name(shape_of(pair)));
    }
    ck_assert_int_eq(regime_applies(SURE_SHAPES, REGIME_TYPICAL), 0);
    ck_assert_int_eq(regime_applies(SURE_SHAPE_CONE, REGIMES), 0);
}
END_TEST

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

START_TEST(test_pure)
{
    if (!applies(_i))
        return;
    enum { COUNT = 100 };
    sure_case forwards[COUNT];
    for (uint64_t i = 0; i < COUNT; i++)
        forwards[i] = made(_i, i);
    int like_first = 0, like_other_seed = 0;
    for (uint64_t i = COUNT; i-- > 0;) {
        sure_case again = made(_i, i);
        sure_case other = regime_case(shape_of(_i), regime_of(_i), SEED + 1, i);
        ck_assert_msg(same(&again, &forwards[i]), "case %" PRIu64 ": %s", i, shown(&again));
        ck_assert_int_eq(again.object.shape, shape_of(_i));
        like_first += same(&again, &forwards[0]);
        like_other_seed += same(&again, &other);
    }
    ck_assert_int_eq(like_first, 1);
    ck_assert_int_eq(like_other_seed, 0);
    /* The far end of the numbers has cases, too. */
    sure_case last = regime_case(shape_of(_i), regime_of(_i), UINT64_MAX, UINT64_MAX);
    ck_assert_int_eq(last.object.shape, shape_of(_i));
}
END_TEST

static uint64_t fnv1a(uint64_t hash, uint64_t word)
{
    for (int i = 0; i < 8; i++, word >>= 8)
        hash = (hash ^ (word & 0xff)) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t hash_of_first(int pair, uint64_t count)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (uint64_t i = 0; i < count; i++) {
        uint64_t bits[CASE_NUMBERS_MAX];
        sure_case c = made(pair, i);
        to_bits(&c, bits);
        for (int k = 0; k < CASE_NUMBERS_MAX; k++)
            hash = fnv1a(hash, bits[k]);
    }
    return hash;
}

/* Of the first 1000 cases (plane, disc, sphere, cylinder, cone; 0 where the regime does not apply). A change
 * here changes what every published number was measured on. */
static const uint64_t frozen[REGIMES][SURE_SHAPES] = {
    [REGIME_TYPICAL] = {0x5523b34bf0a60973, 0xd473a7479e6256a7, 0x6ccef2d58204ff24,
        0xe39df5eed61c84ab, 0x67bc784b3d6f854c},
    [REGIME_GRAZING] = {0x8ef3bc67be2fae2c, 0xb2cba95b16eb9c8f, 0x5f6f052860841e50,
        0x124cbf2e3402e856, 0x7d96a76ac13dcf91},
    [REGIME_TANGENT] = {0xb77826bb168dec27, 0x6e302827bf9171e0, 0x5acf473f2467e0f3,
        0x88a09c8a8ab6b4c3, 0x741e2402da3a4f37},
    [REGIME_NEIGHBOUR] = {0x724cc997f9d15be6, 0xbab837f6229fc7cd, 0x5a33b91592e9d142,
        0x1c0d9d5ab5ff827b, 0xf65c6483bf7131dd},
    [REGIME_FAR] = {0x20968b5d21c833a6, 0xa5fab5198048a814, 0x7ed450d43f75e81e,
        0x706f77c3b2d2ad98, 0x82169d1fbba8e34f},
    [REGIME_HUGE] = {0x2a558f265b653a66, 0x70129e61b5064ee9, 0xea918085c5555c24,
        0x66ab7b3370c53e9d, 0x4d222b094d99713d},
    [REGIME_TINY] = {0xddd0e44a936b5e77, 0x473fb254495520d4, 0x865102b7056398e5,
        0x4ac5f486cd4093e0, 0xb62a977d0295cb3c},
    [REGIME_INSIDE] = {0, 0, 0x968a02882ab0fae9,
        0xc6b770e35c1f0326, 0x0ce59bc175088744},
    [REGIME_ON_SURFACE] = {0x40db3e0879d7cd0b, 0x7ff4f1c7a6044fbc, 0xda164a1f9d3a8c83,
        0x295dcb965a97bc20, 0x6d8a1e3e8ffb8d25},
    [REGIME_RIM] = {0, 0xe0061f8898319931, 0,
        0x75ad49e9b0ea09af, 0x5ee4330d069207a1},
    [REGIME_APEX] = {0, 0, 0,
        0, 0xa2c511064d159c09},
    [REGIME_AXIS_PARALLEL] = {0, 0, 0,
        0x2343ad0e232f1f2f, 0x8aaa65a60262b5b3},
    [REGIME_WALL_PARALLEL] = {0, 0, 0,
        0, 0x23ae1f100597b9d4},
    [REGIME_EDGE_ON] = {0, 0xf5cd3da02ee710d0, 0,
        0x3aebc4ece7992f31, 0x68ab7955b49804ad},
    [REGIME_NEEDLE] = {0, 0, 0,
        0x315823c7991e0ccc, 0xe0f3a33145eebefc},
    [REGIME_COIN] = {0, 0, 0,
        0x9f04c5bb6571ab0a, 0xa7f0199bbac79053},
    [REGIME_DEGENERATE] = {0x4eabcf889b899607, 0x35782c4172c0b9a7, 0x68265b3d0300ff8e,
        0xca40e68b09cbe642, 0xbc95fe759a1c5912},
    [REGIME_INTERVAL] = {0x2ef05956e0fe21ba, 0xa50130e2f6634012, 0x09096b1ac0684709,
        0x354620246ff82293, 0x0738f91a97d02530},
    [REGIME_MIDPOINT] = {0x8a4a7e2f81aa77bf, 0x5ae6bc540a11d797, 0x58ae79f175922846,
        0xa65161253ae25436, 0xc1521205bfecdd7c},
    [REGIME_NONUNIT] = {0x591a58596c958974, 0x0e346a1b84248bdd, 0x221f249fe0af13e6,
        0x5eeb44a5ccb72c87, 0x9fdd57b7aeb290bb},
    [REGIME_INTEGERS] = {0xf6d553e98f02c968, 0x86537ce4971b3a28, 0x3c0b2496825d949d,
        0x5314dc9e5ac0b780, 0xbd32da4eab4cccf5},
    [REGIME_BITS] = {0x4a4022bc60622a10, 0x3764da014e5dc883, 0x8808dd9bdbc6f939,
        0x1e3f9b0a957231be, 0x9d9977d9a02446a0},
};

START_TEST(test_frozen)
{
    if (!applies(_i))
        return;
    uint64_t hash = hash_of_first(_i, 1000);
    uint64_t expected = frozen[regime_of(_i)][shape_of(_i)];
    ck_assert_msg(hash == expected, "%s of %s: 0x%016" PRIx64, regime_name(regime_of(_i)),
                  sure_shape_name(shape_of(_i)), hash);
}
END_TEST

/* The tally of the first cases, by the oracle. */
typedef struct {
    int asked, hit, miss, invalid, inside;
    bool field_seen[SURE_FIELD_RADIUS + 1];
} tally;

static bool starts_inside(const sure_case *valid)
{
    if (valid->object.shape <= SURE_SHAPE_DISC)
        return false;
    point_signs at = point_signs_at(valid, 0, 0);
    return at.round < 0 &&
           (valid->object.shape == SURE_SHAPE_SPHERE || (at.height > 0 && at.over_end < 0));
}

static tally tally_of(int pair)
{
    tally count = {.asked = 500};
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
START_TEST(test_shares)
{
    if (!applies(_i))
        return;
    tally count = tally_of(_i);
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
END_TEST

/* Half hit, a tenth from inside: to a twentieth and a fortieth of the cases. */
START_TEST(test_typical)
{
    tally count = tally_of(REGIME_TYPICAL * SURE_SHAPES + _i);
    ck_assert_int_le(abs(2 * count.hit - count.asked), count.asked / 10);
    if (_i >= SURE_SHAPE_SPHERE)
        ck_assert_int_le(abs(10 * count.inside - count.asked), count.asked / 4);
}
END_TEST

/* Every field of the shape is at fault at times, each of the others never. */
START_TEST(test_degenerate_fields)
{
    static const sure_field own[SURE_SHAPES][4] = {
        {SURE_FIELD_POINT, SURE_FIELD_NORMAL},
        {SURE_FIELD_CENTRE, SURE_FIELD_NORMAL, SURE_FIELD_RADIUS},
        {SURE_FIELD_CENTRE, SURE_FIELD_RADIUS},
        {SURE_FIELD_BASE, SURE_FIELD_TOP, SURE_FIELD_RADIUS},
        {SURE_FIELD_BASE, SURE_FIELD_APEX, SURE_FIELD_RADIUS},
    };
    tally count = tally_of(REGIME_DEGENERATE * SURE_SHAPES + _i);
    for (int field = SURE_FIELD_NONE; field <= SURE_FIELD_RADIUS; field++) {
        bool expected = field <= SURE_FIELD_T_MAX;
        for (int k = 0; k < 4; k++)
            expected = expected || (int)own[_i][k] == field;
        ck_assert_msg(count.field_seen[field] == expected, "%s", sure_field_name((sure_field)field));
    }
}
END_TEST

/* Is the line exactly what the regime is named after? */
static bool exactly(regime which, const sure_case *c)
{
    line_signs line = line_signs_of(c);
    point_signs start = point_signs_at(c, 0, 0);
    sure_shape shape = c->object.shape;
    bool in_cap = line.slope == 0 && (start.height == 0 || start.over_end == 0);
    bool within_height = start.height >= 0 && start.over_end <= 0;
    switch (which) {
    case REGIME_TANGENT:
        if (shape == SURE_SHAPE_PLANE)
            return line.slope == 0;
        if (shape == SURE_SHAPE_DISC && !(line.slope == 0 && start.height == 0))
            return false;
        return line.a > 0 && line.discriminant == 0;
    case REGIME_ON_SURFACE:
        if (shape == SURE_SHAPE_PLANE)
            return start.height == 0;
        if (shape == SURE_SHAPE_DISC)
            return start.height == 0 && start.round <= 0;
        if (shape == SURE_SHAPE_SPHERE)
            return start.round == 0;
        return within_height && start.round <= 0 &&
               (start.round == 0 || start.height == 0 ||
                (shape == SURE_SHAPE_CYLINDER && start.over_end == 0));
    case REGIME_RIM:
        return line.meets_base_rim || (shape == SURE_SHAPE_CYLINDER && line.meets_end_rim);
    case REGIME_APEX:
        return line.meets_apex;
    case REGIME_AXIS_PARALLEL:
        return line.along_axis;
    case REGIME_WALL_PARALLEL:
        return line.a == 0;
    case REGIME_EDGE_ON:
        return in_cap && (shape == SURE_SHAPE_CYLINDER || start.height == 0);
    default:
        return false;
    }
}

static int count_exact(int pair, int asked)
{
    int exact = 0;
    for (int i = 0; i < asked; i++) {
        sure_case c = made(pair, (uint64_t)i);
        exact += exactly(regime_of(pair), &c);
    }
    return exact;
}

/* What is built in whole numbers has not been rounded: all of it, or the half or third that is not moved on
 * purpose. */
START_TEST(test_exact)
{
    static const struct {
        regime which;
        int one_in;
    } share[] = {{REGIME_TANGENT, 1},       {REGIME_ON_SURFACE, 1},    {REGIME_RIM, 2},
                 {REGIME_APEX, 2},          {REGIME_AXIS_PARALLEL, 3}, {REGIME_WALL_PARALLEL, 3},
                 {REGIME_EDGE_ON, 3}};
    enum { COUNT = 1000 };
    if (!applies((int)share[_i].which * SURE_SHAPES + SURE_SHAPE_CONE))
        ck_abort();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        int pair = (int)share[_i].which * SURE_SHAPES + shape;
        if (!applies(pair))
            continue;
        int exact = count_exact(pair, COUNT);
        int meant = COUNT / share[_i].one_in;
        ck_assert_msg(exact >= meant - (share[_i].one_in > 1 ? COUNT / 20 : 0), "%s of %s: %d",
                      regime_name(share[_i].which), sure_shape_name((sure_shape)shape), exact);
        if (share[_i].one_in > 1)
            ck_assert_int_le(exact, meant + COUNT / 5);
    }
}
END_TEST

static double step(double x, int steps)
{
    for (; steps > 0; steps--)
        x = nextafter(x, INFINITY);
    for (; steps < 0; steps++)
        x = nextafter(x, -INFINITY);
    return x;
}

static bool tangent_when_moved(const sure_case *c, int which, int steps)
{
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(c, number);
    number[which] = step(number[which], steps);
    sure_case moved = case_from_numbers(c->object.shape, number);
    return exactly(REGIME_TANGENT, &moved);
}

/* One number of a neighbour moved by at most 4 ulps makes it exactly tangent, and few are so already (the
 * range is a number, too, and a step along the ray is none away from the tangent). */
START_TEST(test_neighbour)
{
    enum { COUNT = 100 };
    int already = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        sure_case c = made(REGIME_NEIGHBOUR * SURE_SHAPES + _i, i);
        int count = case_numbers(c.object.shape);
        bool found = exactly(REGIME_TANGENT, &c);
        already += found;
        for (int which = 0; which < count && !found; which++)
            for (int steps = -4; steps <= 4 && !found; steps++)
                found = which != 6 && which != 7 && tangent_when_moved(&c, which, steps);
        ck_assert_msg(found, "%s", shown(&c));
    }
    ck_assert_int_le(2 * already, COUNT);
}
END_TEST

static double length_of(double x, double y, double z)
{
    return hypot(hypot(x, y), z);
}

/* Of the three numbers from `first` on, without those from `from` on, if any. */
static double way(const double *number, int first, int from)
{
    double v[3];
    for (int i = 0; i < 3; i++)
        v[i] = number[first + i] - (from < 0 ? 0 : number[from + i]);
    return length_of(v[0], v[1], v[2]);
}

static void numbers_of(regime which, sure_shape shape, uint64_t index, double number[15])
{
    sure_case c = regime_case(shape, which, SEED, index);
    case_to_numbers(&c, number);
}

START_TEST(test_far)
{
    if (_i == SURE_SHAPE_PLANE)
        return;
    double farthest = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_FAR, (sure_shape)_i, i, number);
        double radii = way(number, 0, 8) / number[case_numbers((sure_shape)_i) - 1];
        ck_assert(radii > 0x1p9 && radii < 0x1p51);
        farthest = fmax(farthest, radii);
    }
    ck_assert(farthest > 0x1p49);
}
END_TEST

static double largest(const double *number, int count)
{
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(number[i]));
    return most;
}

/* The least of the huge has a square that overflows, the largest of the tiny one that underflows. */
START_TEST(test_huge_and_tiny)
{
    sure_shape shape = (sure_shape)_i;
    bool normal = shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC;
    bool subnormal = false;
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_HUGE, shape, i, number);
        ck_assert(fmax(largest(number, 3), largest(number + 8, 3)) >= 0x1p510);
        ck_assert(largest(number, 3) <= 1e300 && largest(number + 8, 3) <= 1e300);
        numbers_of(REGIME_TINY, shape, i, number);
        double most = fmax(largest(number, 3), largest(number + 8, normal ? 3 : 4));
        ck_assert(most * most == 0 || most < 0x1p-511);
        subnormal = subnormal || (most > 0 && most < DBL_MIN);
    }
    ck_assert(subnormal);
}
END_TEST

START_TEST(test_needle_and_coin)
{
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_NEEDLE, (sure_shape)_i, i, number);
        double slender = way(number, 11, 8) / number[14];
        ck_assert(slender > 0x1p37 && slender < 0x1p43);
        numbers_of(REGIME_COIN, (sure_shape)_i, i, number);
        double flat = number[14] / way(number, 11, 8);
        ck_assert(flat > 0x1p37 && flat < 0x1p43);
    }
}
END_TEST

static bool far_from_unit(double length)
{
    return length > 0x1p250 || length < 0x1p-250;
}

/* |d|, or the normal or axis, is. */
START_TEST(test_nonunit)
{
    int d = 0, other = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_NONUNIT, (sure_shape)_i, i, number);
        bool this_d = far_from_unit(way(number, 3, -1)), this_other = false;
        if (_i != SURE_SHAPE_SPHERE)
            this_other = far_from_unit(way(number, 11, _i > SURE_SHAPE_SPHERE ? 8 : -1));
        ck_assert(this_d || this_other);
        d += this_d;
        other += this_other;
    }
    ck_assert(d > 500 && (_i == SURE_SHAPE_SPHERE || other > 250));
}
END_TEST

/* The impact parameter is r (1 +- 2^-6) at most, and in half of cases far closer. */
START_TEST(test_grazing)
{
    int close = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        sure_case c = regime_case(SURE_SHAPE_SPHERE, REGIME_GRAZING, SEED, i);
        sure_vec3 o = c.ray.origin, d = c.ray.direction, m = c.object.as.sphere.centre;
        double w[3] = {o.x - m.x, o.y - m.y, o.z - m.z};
        double impact = length_of(w[1] * d.z - w[2] * d.y, w[2] * d.x - w[0] * d.z,
                                  w[0] * d.y - w[1] * d.x) /
                        length_of(d.x, d.y, d.z);
        double off = fabs(impact / c.object.as.sphere.radius - 1);
        ck_assert_msg(off < 0x1p-5, "%a: %s", off, shown(&c));
        close += off < 0x1p-16;
    }
    ck_assert_int_gt(close, 500);
}
END_TEST

START_TEST(test_inside)
{
    if (!applies(REGIME_INSIDE * SURE_SHAPES + _i))
        return;
    for (uint64_t i = 0; i < 1000; i++) {
        sure_case c = made(REGIME_INSIDE * SURE_SHAPES + _i, i);
        ck_assert_msg(starts_inside(&c), "%s", shown(&c));
    }
}
END_TEST

/* There is a boundary point within three ulps of an end of the range, and in half of cases within one. */
START_TEST(test_interval)
{
    enum { COUNT = 500 };
    int near = 0, nearest = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        sure_case c = made(REGIME_INTERVAL * SURE_SHAPES + _i, i);
        double end = isinf(c.ray.t_max) ? c.ray.t_min : c.ray.t_max;
        bisection_result truth;
        c.ray.t_min = step(end, -3);
        c.ray.t_max = step(end, 3);
        near += bisection_answer(&c.ray, &c.object, &truth) == SURE_HIT;
        c.ray.t_min = step(end, -1);
        c.ray.t_max = step(end, 1);
        nearest += bisection_answer(&c.ray, &c.object, &truth) == SURE_HIT;
    }
    ck_assert_msg(near == COUNT && 2 * nearest > COUNT, "%d, %d of %d", near, nearest, COUNT);
}
END_TEST

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
    midpoints next = midpoints_next_to(t);
    for (int i = 0; i < 2; i++) {
        point_signs at = point_signs_at(c, next.m[i], next.exponent);
        bool flat = at.height == 0 || (c->object.shape == SURE_SHAPE_CYLINDER && at.over_end == 0);
        if (c->object.shape == SURE_SHAPE_SPHERE ? at.round == 0
                                                 : flat || (c->object.shape > SURE_SHAPE_SPHERE &&
                                                            at.round == 0))
            return true;
    }
    return false;
}

/* Of the hits of the whole ray half are exactly halfway between two doubles; all kinds of doubles occur. */
START_TEST(test_midpoint)
{
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
    ck_assert_msg(hits > 800 && 5 * halfway > 2 * hits && 5 * halfway < 4 * hits, "%d of %d",
                  halfway, hits);
    ck_assert(subnormal > 50 && overflow > 20 && normal > 200);
}
END_TEST

static int by_value(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* The first cases of the world, or all of them, differ in pairs; behind its end it begins again. */
START_TEST(test_integers)
{
    sure_shape shape = (sure_shape)_i;
    uint64_t all = regime_integers_count(shape);
    uint64_t count = shape == SURE_SHAPE_SPHERE ? all : 300000;
    uint64_t *code = malloc(count * sizeof *code);
    ck_assert_ptr_nonnull(code);
    for (uint64_t i = 0; i < count; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_INTEGERS, shape, i, number);
        code[i] = 0;
        for (int k = 0; k < case_numbers(shape); k++) {
            /* -3 .. 3, and infinity as 4. */
            int digit = isinf(number[k]) ? 4 : (int)number[k];
            ck_assert(digit >= -3 && (digit == number[k] || k == 7));
            code[i] = code[i] * 8 + (uint64_t)(digit + 3);
        }
    }
    qsort(code, count, sizeof *code, by_value);
    for (uint64_t i = 1; i < count; i++)
        ck_assert(code[i - 1] != code[i]);
    free(code);
    sure_case first = regime_case(shape, REGIME_INTEGERS, SEED, 0);
    sure_case again = regime_case(shape, REGIME_INTEGERS, SEED, all);
    ck_assert(same(&first, &again));
}
END_TEST

/* All numbers but the range take every class of exponent and mantissa. */
START_TEST(test_bits)
{
    enum { COUNT = 1000 };
    for (int k = 0; k < case_numbers((sure_shape)_i); k++) {
        int zero = 0, subnormal = 0, power = 0, ones = 0, huge = 0, one = 0;
        for (uint64_t i = 0; i < COUNT; i++) {
            double number[CASE_NUMBERS_MAX];
            int e;
            numbers_of(REGIME_BITS, (sure_shape)_i, i, number);
            double x = fabs(number[k]), mantissa = frexp(x, &e);
            zero += x == 0;
            subnormal += x > 0 && x < DBL_MIN;
            power += mantissa == 0.5;
            ones += mantissa == 1 - DBL_EPSILON / 2;
            huge += isfinite(x) && x > 0x1p1000;
            one += x > 0x1p-8 && x < 0x1p8;
        }
        bool in_range = k == 6 || k == 7;
        ck_assert_msg((zero || k == 7) && subnormal && power && (ones || in_range) && huge && one,
                      "number %d", k);
    }
}
END_TEST

static void add(Suite *suite, const char *name, const TTest *test, int first, int end)
{
    TCase *tests = tcase_create(name);
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, test, first, end);
    suite_add_tcase(suite, tests);
}

int main(void)
{
    Suite *suite = suite_create("regimes");
    add(suite, "names", test_names, 0, 1);
    add(suite, "applies", test_applies, 0, 1);
    add(suite, "pure", test_pure, 0, PAIRS);
    add(suite, "frozen", test_frozen, 0, PAIRS);
    add(suite, "shares", test_shares, 0, PAIRS);
    add(suite, "typical", test_typical, 0, SURE_SHAPES);
    add(suite, "degenerate fields", test_degenerate_fields, 0, SURE_SHAPES);
    add(suite, "exact", test_exact, 0, 7);
    add(suite, "neighbour", test_neighbour, 0, SURE_SHAPES);
    add(suite, "far", test_far, 0, SURE_SHAPES);
    add(suite, "huge and tiny", test_huge_and_tiny, 0, SURE_SHAPES);
    add(suite, "needle and coin", test_needle_and_coin, SURE_SHAPE_CYLINDER, SURE_SHAPES);
    add(suite, "nonunit", test_nonunit, 0, SURE_SHAPES);
    add(suite, "grazing", test_grazing, 0, 1);
    add(suite, "inside", test_inside, 0, SURE_SHAPES);
    add(suite, "interval", test_interval, 0, SURE_SHAPES);
    add(suite, "midpoint", test_midpoint, 0, SURE_SHAPES);
    add(suite, "integers", test_integers, 0, SURE_SHAPES);
    add(suite, "bits", test_bits, 0, SURE_SHAPES);
    return suite_run(suite);
}
