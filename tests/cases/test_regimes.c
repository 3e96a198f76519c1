/* The named generators: pure, unchanging, valid, of both outcomes, and as hard as their names say.
 * What they claim is checked in exact integers (line_signs.h) and against the bisection oracle. */
#include "suite.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../reference/bisection.h"
#include "../../src/cases/regimes.h"
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
    [REGIME_OFF_SURFACE] = "plane disc sphere cylinder cone",
    [REGIME_NEARLY_PARALLEL] = "plane disc cylinder cone",
    [REGIME_FAR_TANGENT] = "plane disc sphere cylinder cone",
    [REGIME_SCALED_NEIGHBOUR] = "plane disc sphere cylinder cone",
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
    int like_first = 0, like_other = 0;
    for (uint64_t i = COUNT; i-- > 0;) {
        sure_case again = made(_i, i);
        /* No bit of seed or index is ignored. */
        uint64_t seed = SEED ^ UINT64_C(1) << (i % 64);
        sure_case other_seed = regime_case(shape_of(_i), regime_of(_i), seed, i);
        sure_case other_index = made(_i, i ^ UINT64_C(1) << (i % 63 + 1));
        ck_assert_msg(same(&again, &forwards[i]), "case %" PRIu64 ": %s", i, shown(&again));
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

/* Of the first 1000 cases (plane, disc, sphere, cylinder, cone; 0 where the regime does not apply).
 * A change here changes what every published number was measured on. */
static const uint64_t frozen[REGIMES][SURE_SHAPES] = {
    [REGIME_TYPICAL] = {0x5523b34bf0a60973, 0xd473a7479e6256a7, 0x2214c4a5e4af5c87,
        0x56b2079476507f6a, 0x6c325e8701a605a2},
    [REGIME_GRAZING] = {0xf3d43efa342734d0, 0xd1ec3c4b69db8025, 0xcddd1cd448f15248,
        0xd714d60461dc5b7b, 0x7d96a76ac13dcf91},
    [REGIME_TANGENT] = {0xb7d55e05516d5593, 0x2b2045c9238a7e5f, 0xe70ecd7a42f47a40,
        0x4781fb2e7c8a9f77, 0x741e2402da3a4f37},
    [REGIME_NEIGHBOUR] = {0xe497b1b40e9bfe1e, 0x2493647d4d9cc8bb, 0x6a854e6be8c43c35,
        0x3469ad37042c06c1, 0x39dfc590fa4db22d},
    [REGIME_FAR] = {0x20968b5d21c833a6, 0xa5fab5198048a814, 0x25f7d52b30e2a9a0,
        0x985bd5fa7bc28962, 0x0ef97edf2544da41},
    [REGIME_HUGE] = {0x7b7c437b225d3b32, 0x72fdd6e0a6bec3d5, 0x338f41db346655db,
        0x04559196f56de85e, 0xf5245afb7966787a},
    [REGIME_TINY] = {0x45ba40640473e9f4, 0xf7116faaae1a4a48, 0x5aebe637ff253f1e,
        0x2e7080b6682a4b7a, 0x994c7a8281d7d0ab},
    [REGIME_INSIDE] = {0, 0, 0x968a02882ab0fae9,
        0xc6b770e35c1f0326, 0x0ce59bc175088744},
    [REGIME_ON_SURFACE] = {0x53a30ac8c13f354f, 0xf8731f72b233fe70, 0x721ee7fe20b29953,
        0xf0645ff99cf4aecb, 0x4dd3772efbb8c0ec},
    [REGIME_RIM] = {0, 0xf44e50c0cdba04cd, 0,
        0x38aabb86643f9015, 0xd4d08cac0643dcc5},
    [REGIME_APEX] = {0, 0, 0,
        0, 0x749a9b743f8c2127},
    [REGIME_AXIS_PARALLEL] = {0, 0, 0,
        0xcb19cebf099ac02d, 0x4c25f2a685deba3b},
    [REGIME_WALL_PARALLEL] = {0, 0, 0,
        0, 0x23ae1f100597b9d4},
    [REGIME_EDGE_ON] = {0, 0xfc18a2925c45cd6e, 0,
        0x9f0d10020cf6a74f, 0x132dc72459300836},
    [REGIME_NEEDLE] = {0, 0, 0,
        0x315823c7991e0ccc, 0xe0f3a33145eebefc},
    [REGIME_COIN] = {0, 0, 0,
        0x9f04c5bb6571ab0a, 0xa7f0199bbac79053},
    [REGIME_DEGENERATE] = {0x4e0244db68877801, 0x7ded4bbbc4275bd3, 0xbb1b1441de03b540,
        0x9e1c20508843a09d, 0x18450b0bcc48160f},
    [REGIME_INTERVAL] = {0x883d558c578a1cb4, 0x7de56a8bcd8058df, 0x2ada424756faacdc,
        0x40f49cfe01b7dcc2, 0x9eade8cebfae875f},
    [REGIME_MIDPOINT] = {0x5c736430165a4cc5, 0xe6f9a58c6809d2bf, 0x1148bbdb27591551,
        0x4439bb32f645dc52, 0x842458a1da900ba0},
    [REGIME_NONUNIT] = {0x591a58596c958974, 0x0e346a1b84248bdd, 0xab23f98839229676,
        0x64316c892f9336bd, 0x028a7b109486fabe},
    [REGIME_INTEGERS] = {0xf6d553e98f02c968, 0x86537ce4971b3a28, 0x3c0b2496825d949d,
        0x5314dc9e5ac0b780, 0xbd32da4eab4cccf5},
    [REGIME_BITS] = {0xd33d633c213e60cf, 0x23c2b946667cede7, 0xf28bc32ffccd3551,
        0xb675d03af6faebdb, 0x395913e80a050fe5},
    [REGIME_OFF_SURFACE] = {0x5b9a26710f3ff28f, 0x109c01c4f15d3e57, 0xe3baa6b7a844f802,
        0x5096ec29d7deba1c, 0x6693d47338bacaae},
    [REGIME_NEARLY_PARALLEL] = {0x5cffe1d0f9ea5679, 0x7541c691cbc484f0, 0,
        0xfe2141230d894ccd, 0xd08deed551e7d61f},
    [REGIME_FAR_TANGENT] = {0x74a602518e29806b, 0x8dc2c9b4ea24d880, 0x5a8030c601be5aeb,
        0x8a760978cc09f6b2, 0xbc22eb83430ee315},
    [REGIME_SCALED_NEIGHBOUR] = {0xc2ec661b9f387858, 0x93a14efaa1b84e52, 0xd2ae5385e2e7f660,
        0x8503be4725c57f26, 0x58aafe5858a52feb},
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
START_TEST(test_shares)
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
END_TEST

/* Half hit, a tenth from inside: to a twentieth and a fortieth of the cases. */
START_TEST(test_typical)
{
    tally count = tally_of(REGIME_TYPICAL * SURE_SHAPES + _i, 2000);
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
    tally count = tally_of(REGIME_DEGENERATE * SURE_SHAPES + _i, 500);
    for (int field = SURE_FIELD_NONE; field <= SURE_FIELD_RADIUS; field++) {
        bool expected = field <= SURE_FIELD_T_MAX;
        for (int k = 0; k < 4; k++)
            expected = expected || (int)own[_i][k] == field;
        ck_assert_msg(count.field_seen[field] == expected, "%s",
                      sure_field_name((sure_field)field));
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
    case REGIME_FAR_TANGENT:
    case REGIME_SCALED_NEIGHBOUR:
        return exactly(REGIME_TANGENT, c) || exactly(REGIME_RIM, c);
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

/* What is built in whole numbers has not been rounded: all of it, or the half or third that is not
 * moved on purpose. */
START_TEST(test_exact)
{
    static const struct {
        regime which;
        int one_in;
    } share[] = {{REGIME_TANGENT, 1},       {REGIME_ON_SURFACE, 1},    {REGIME_RIM, 2},
                 {REGIME_APEX, 2},          {REGIME_AXIS_PARALLEL, 3}, {REGIME_WALL_PARALLEL, 3},
                 {REGIME_EDGE_ON, 3},     {REGIME_FAR_TANGENT, 2},
                 {REGIME_SCALED_NEIGHBOUR, 2}};
    enum { COUNT = 1000 };
    if (!applies((int)share[_i].which * SURE_SHAPES + SURE_SHAPE_CONE))
        ck_abort();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        int pair = (int)share[_i].which * SURE_SHAPES + shape;
        if (!applies(pair) || pair == REGIME_FAR_TANGENT * SURE_SHAPES + SURE_SHAPE_PLANE)
            continue; /* from afar a plane is crossed */
        int exact = count_exact(pair, COUNT);
        int meant = COUNT / share[_i].one_in;
        ck_assert_msg(exact >= meant - (share[_i].one_in > 1 ? COUNT / 20 : 0), "%s of %s: %d",
                      regime_name(share[_i].which), sure_shape_name((sure_shape)shape), exact);
        /* What is moved along the ray, or along a plane, is as exact as before. */
        if (share[_i].one_in > 1 && shape != SURE_SHAPE_PLANE)
            ck_assert_msg(exact <= meant + 3 * COUNT / 10, "%s of %s: %d",
                          regime_name(share[_i].which), sure_shape_name((sure_shape)shape), exact);
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

/* Does the line touch the object, or the infinite wall, at one point or lie in the plane? */
static bool touches(const sure_case *c)
{
    return exactly(REGIME_TANGENT, c) &&
           (c->object.shape != SURE_SHAPE_PLANE || point_signs_at(c, 0, 0).height == 0);
}

static bool tangent_when_moved(const sure_case *c, int which, int steps)
{
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(c, number);
    number[which] = step(number[which], steps);
    sure_case moved = case_from_numbers(c->object.shape, number);
    return exactly(REGIME_TANGENT, &moved);
}

/* One number of a neighbour moved by at most 4 ulps makes it exactly tangent, and few are so
 * already (the range is a number, too, and a step along the ray is none away from the tangent). */
START_TEST(test_neighbour)
{
    enum { COUNT = 100 };
    int already = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        sure_case c = made(REGIME_NEIGHBOUR * SURE_SHAPES + _i, i);
        int count = case_numbers(c.object.shape);
        bool found = exactly(REGIME_TANGENT, &c);
        already += touches(&c);
        for (int which = 0; which < count && !found; which++)
            for (int steps = -4; steps <= 4 && !found; steps++)
                found = which != 6 && which != 7 && tangent_when_moved(&c, which, steps);
        ck_assert_msg(found, "%s", shown(&c));
    }
    ck_assert_msg(2 * already <= COUNT, "%d", already);
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

/* The huge have squares that overflow (where a ray does not start at the origin, in a plane's
 * point), the tiny have squares that underflow. */
START_TEST(test_huge_and_tiny)
{
    sure_shape shape = (sure_shape)_i;
    bool normal = shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC;
    bool subnormal = false;
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_HUGE, shape, i, number);
        double most = fmax(largest(number, 3), largest(number + 8, 3));
        ck_assert((most >= 0x1p510 && most <= 0x1p996) || (most == 0 && _i == SURE_SHAPE_PLANE));
        numbers_of(REGIME_TINY, shape, i, number);
        most = fmax(largest(number, 3), largest(number + 8, normal ? 3 : 4));
        ck_assert(most * most == 0 || most < 0x1p-511);
        subnormal = subnormal || (most > 0 && most < DBL_MIN);
    }
    ck_assert(subnormal);
}
END_TEST

/* One coordinate of the start moved by one ulp is on the boundary, and few starts are so already (a
 * step along a plane is none off it). */
START_TEST(test_off_surface)
{
    enum { COUNT = 300 };
    int already = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        sure_case c = made(REGIME_OFF_SURFACE * SURE_SHAPES + _i, i);
        bool found = exactly(REGIME_ON_SURFACE, &c);
        already += found;
        for (int k = 0; k < 6 && !found; k++) {
            sure_case moved = c;
            double *o[3] = {&moved.ray.origin.x, &moved.ray.origin.y, &moved.ray.origin.z};
            *o[k / 2] = step(*o[k / 2], k % 2 == 0 ? 1 : -1);
            found = exactly(REGIME_ON_SURFACE, &moved);
        }
        ck_assert_msg(found, "%s", shown(&c));
    }
    ck_assert_msg(2 * already <= COUNT, "%d", already);
}
END_TEST

/* From 2^5 radii to 2^40 and more. */
START_TEST(test_far_tangent)
{
    double farthest = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        double number[CASE_NUMBERS_MAX];
        numbers_of(REGIME_FAR_TANGENT, (sure_shape)_i, i, number);
        double radii = way(number, 0, 8) / number[case_numbers((sure_shape)_i) - 1];
        ck_assert_msg(radii > 0x1p5 && radii < 0x1p47, "%a", radii);
        farthest = fmax(farthest, radii);
    }
    ck_assert(farthest > 0x1p40);
}
END_TEST

/* The slope against a flat face, or against the axis, is 2^-30 .. 2^-20. */
START_TEST(test_nearly_parallel)
{
    sure_shape shape = (sure_shape)_i;
    if (!applies(REGIME_NEARLY_PARALLEL * SURE_SHAPES + _i))
        return;
    for (uint64_t i = 0; i < 1000; i++) {
        double x[CASE_NUMBERS_MAX];
        numbers_of(REGIME_NEARLY_PARALLEL, shape, i, x);
        double n[3], *d = x + 3;
        for (int k = 0; k < 3; k++)
            n[k] = x[11 + k] - (shape > SURE_SHAPE_SPHERE ? x[8 + k] : 0);
        double along = fabs(d[0] * n[0] + d[1] * n[1] + d[2] * n[2]);
        double across = length_of(d[1] * n[2] - d[2] * n[1], d[2] * n[0] - d[0] * n[2],
                                  d[0] * n[1] - d[1] * n[0]);
        double slope = shape > SURE_SHAPE_SPHERE ? across / along : along / across;
        ck_assert_msg(slope > 0x1p-31 && slope < 0x1p-19, "case %" PRIu64 ": %a", i, slope);
    }
}
END_TEST

/* Squares of lengths overflow or underflow, and no length is near the subnormals. */
START_TEST(test_scaled_neighbour)
{
    sure_shape shape = (sure_shape)_i;
    int huge = 0, tiny = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        double x[CASE_NUMBERS_MAX];
        numbers_of(REGIME_SCALED_NEIGHBOUR, shape, i, x);
        double most = fmax(largest(x, 3), largest(x + 8, 3));
        if (shape == SURE_SHAPE_SPHERE)
            most = fmax(most, x[11]);
        huge += most > 0x1p600 && most <= 0x1p997;
        tiny += most < 0x1p-690 && most > 0x1p-1000;
    }
    ck_assert_msg(huge > 400 && tiny > 400 && huge + tiny == 1000, "%d, %d", huge, tiny);
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

/* There is a boundary point within five ulps of an end of the range, and in half of cases within
 * one. */
START_TEST(test_interval)
{
    enum { COUNT = 500 };
    int near = 0, nearest = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        sure_case c = made(REGIME_INTERVAL * SURE_SHAPES + _i, i);
        double end = isinf(c.ray.t_max) ? c.ray.t_min : c.ray.t_max;
        bisection_result truth;
        c.ray.t_min = step(end, -5);
        c.ray.t_max = step(end, 5);
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

/* Of the hits of the whole ray half are exactly halfway between two doubles; all kinds of doubles
 * occur. */
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
    ck_assert_msg(hits > 700 && 5 * halfway > 2 * hits && 5 * halfway < 4 * hits, "%d of %d",
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
            if (digit < -3 || !(digit == number[k] || k == 7))
                ck_abort_msg("number %d: %a", k, number[k]);
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
        ck_assert_msg((zero || k == 7) && subnormal && power &&
                          (50 * ones > COUNT || in_range) && huge && one,
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
    add(suite, "exact", test_exact, 0, 9);
    add(suite, "neighbour", test_neighbour, 0, SURE_SHAPES);
    add(suite, "far", test_far, 0, SURE_SHAPES);
    add(suite, "huge and tiny", test_huge_and_tiny, 0, SURE_SHAPES);
    add(suite, "off surface", test_off_surface, 0, SURE_SHAPES);
    add(suite, "far tangent", test_far_tangent, SURE_SHAPE_DISC, SURE_SHAPES);
    add(suite, "nearly parallel", test_nearly_parallel, 0, SURE_SHAPES);
    add(suite, "scaled neighbour", test_scaled_neighbour, 0, SURE_SHAPES);
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
