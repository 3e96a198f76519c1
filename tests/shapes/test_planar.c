/* SPDX-License-Identifier: MIT */
/* The first two stages of plane and disc, held against numbers wide enough to be exact: the first
 * hit itself, not the chord alone, and the numbers that the disc's decide on. */
#include "../../src/shapes/disc/disc_close.h"
#include "../../src/stages/close.h"
#include "../../src/stages/rows.h"
#include "../support/every_case.h"
#include "../support/objects.h"

enum { BITS = 12000, NEAR = 3000, AT_PLACE = AT_OBJECT, AT_NORMAL = AT_OBJECT + 3 };

/* |p|^2 - r^2 of the point where the plane is crossed, in `outside`; its t in `t`. */
static void crossing_of(const true_line *line, mpfr_t t, mpfr_t outside)
{
    mpfr_neg(t, line->level, MPFR_RNDN);
    mpfr_div(t, t, line->slope, MPFR_RNDN);
    mpfr_mul(outside, line->a, t, MPFR_RNDN);
    mpfr_add(outside, outside, line->b, MPFR_RNDN);
    mpfr_add(outside, outside, line->b, MPFR_RNDN);
    mpfr_fma(outside, outside, t, line->c, MPFR_RNDN);
}

static sure_case drawn(sure_shape shape, uint64_t i)
{
    double numbers[CASE_NUMBERS_MAX];
    int reach = (int)(suite_bits(41, i) % 50), slope = (int)(suite_bits(42, i) % 50);
    double beside = power_of_two(-(int)(suite_bits(60, i) % 30));
    bool within = suite_bits(43, i) % 4 == 0;
    for (int k = 0; k < CASE_NUMBERS_MAX; k++)
        numbers[k] = suite_double(44 + (uint64_t)k, i, 0);
    for (int k = 0; k < 3; k++) {
        numbers[k] = numbers[AT_PLACE + k] - numbers[3 + k] * power_of_two(reach);
        numbers[k] += k < 2 ? suite_double(62 + (uint64_t)k, i, 0) * beside : 0;
    }
    if (within || suite_bits(61, i) % 2 == 0) {
        numbers[AT_NORMAL] = numbers[AT_NORMAL + 1] = 0;
        numbers[AT_PLACE + 2] = numbers[2] = 0;
        numbers[5] = within ? 0 : numbers[5] * power_of_two(-slope);
        numbers[2] = within ? 0 : -numbers[5] * power_of_two(reach);
    }
    numbers[AT_T_MIN] = 0;
    numbers[AT_T_MIN + 1] = INFINITY;
    return case_from_numbers(shape, numbers);
}

/* The point next to the place: its t, and |p|^2 - r^2. */
static void foot_of(const true_line *line, mpfr_t t, mpfr_t outside)
{
    mpfr_div(t, line->b, line->a, MPFR_RNDN);
    mpfr_mul(outside, t, line->b, MPFR_RNDN);
    mpfr_neg(t, t, MPFR_RNDN);
    mpfr_sub(outside, line->c, outside, MPFR_RNDN);
}

/* Case i whose t_min and radius are what the line has, but for a few ulps: all mantissas full, a
 * part of the lines within the plane z = 0, from up to 2^50 radii away, slopes down to 2^-50. */
static sure_case near_case(sure_shape shape, uint64_t i, true_line *line)
{
    sure_case c = drawn(shape, i);
    TRUE_NUMBERS(BITS, t, outside);
    true_line_set(line, &c);
    (mpfr_zero_p(line->slope) ? foot_of : crossing_of)(line, t, outside);
    double near = mpfr_get_d(t, MPFR_RNDN), ulps = (double)suite_integer(64, i, 4) * 0x1p-53;
    if (suite_bits(65, i) % 2 == 0 && near > 0)
        c.ray.t_min = near + near * ulps * power_of_two((int)(suite_bits(66, i) % 8));
    if (line->round) {
        mpfr_set_d(t, c.object.as.disc.radius, MPFR_RNDN);
        mpfr_fma(outside, t, t, outside, MPFR_RNDN);
        mpfr_sqrt(outside, outside, MPFR_RNDN);
        double r = mpfr_get_d(outside, MPFR_RNDN);
        c.object.as.disc.radius = r + r * (double)suite_integer(67, i, 4) * 0x1p-53;
    }
    return c;
}

/* Calls both for such cases in each environment. */
static void in_each_near(sure_shape shape, case_compute *what, case_compute *judge, void *context)
{
    TRUE_LINE(BITS, line);
    for (uint64_t i = 0; i < NEAR; i++) {
        sure_case c = near_case(shape, i, &line);
        if (case_is_valid(&c))
            in_each_environment(&c, what, judge, context);
    }
}

/* What was answered. */
typedef struct {
    true_line truth;
    mpfr_t t;
    filter_verdict filter, close[2]; /* by t_wanted */
    filter_end first;
    sure_hit hits[2];
    long all, close_asked, close_answers;
    double worst;
} answers;

static void ask(const sure_case *c, void *context)
{
    answers *of = context;
    const shape_row *row = row_of(&c->object);
    filter_interval found;
    of->filter = row->filter(&c->ray, &c->object.as, &found);
    if (of->filter == FILTER_INTERVAL)
        of->filter = filter_first(&found, &c->ray, &of->first);
    of->close[0] = of->close[1] = FILTER_UNCERTAIN;
    for (int wanted = 0; wanted < 2 && environment_is_nearest(); wanted++)
        of->close[wanted] =
            close_of(row)->refine_hit(&c->ray, &c->object.as, (t_wanted)wanted, &of->hits[wanted]);
}

static void judge_certain(answers *of, const sure_case *c)
{
    const sure_hit *hit = &of->hits[T_CERTAIN];
    double share = share_of_error(of->t, hit->t, hit->t_error);
    of->worst = fmax(of->worst, share);
    case_require(c, share <= 1, "beyond the bound");
    case_require(c, hit->t >= c->ray.t_min && hit->t <= c->ray.t_max, "beyond the range");
}

static void judge_exact(answers *of, const sure_case *c)
{
    const sure_hit *hit = &of->hits[T_EXACT];
    double rounded = mpfr_get_d(of->t, MPFR_RNDN);
    case_require(c, hit->t == rounded && signbit(hit->t) == 0, "wrongly rounded");
    case_require(c, hit->t_error == 0 || hit->t_error == half_ulp(hit->t), "half ulp");
}

static void judge(const sure_case *c, void *context)
{
    answers *of = context;
    true_line_set(&of->truth, c);
    bool hits = true_first(&of->truth, of->t);
    of->all++;
    case_require(c, of->filter != FILTER_MISS || !hits, "the filter: no miss");
    case_require(c, of->filter != FILTER_INTERVAL || hits, "the filter: no hit");
    for (int wanted = 0; wanted < 2; wanted++) {
        case_require(c, of->close[wanted] != FILTER_MISS || !hits, "closely: no miss");
        case_require(c, of->close[wanted] != FILTER_INTERVAL || hits, "closely: no hit");
    }
    of->close_asked += of->filter == FILTER_UNCERTAIN;
    of->close_answers += of->filter == FILTER_UNCERTAIN && of->close[0] != FILTER_UNCERTAIN;
    if (of->close[T_CERTAIN] == FILTER_INTERVAL)
        judge_certain(of, c);
    if (of->close[T_EXACT] == FILTER_INTERVAL)
        judge_exact(of, c);
}

typedef void each_case(sure_shape shape, case_compute *what, case_compute *judge, void *context);

/* Of what the filter leaves at least one in `share` of all cases is answered. */
static void run(sure_shape shape, each_case *each, const char *what, long share)
{
    answers of = {.all = 0};
    if (!close_rows[shape].refine_hit)
        return;
    true_line_init(&of.truth, BITS);
    mpfr_init2(of.t, BITS);
    each(shape, ask, judge, &of);
    true_line_clear(&of.truth);
    mpfr_clear(of.t);
    printf("%-8s %-13s error/bound %.3f  of %ld left by the filter %ld answered\n",
           sure_shape_name(shape), what, of.worst, of.close_asked, of.close_answers);
    fflush(stdout);
    ck_assert_int_gt(of.close_answers, of.all / share);
}

LOOP_TEST(test_regimes, SURE_SHAPES)
{
    run((sure_shape)_i, in_each_regime, "closely", 10);
}

/* Crossings at about t_min and about the rim, to within roundings. */
LOOP_TEST(test_near, SURE_SHAPES)
{
    run((sure_shape)_i, in_each_near, "near", 20);
}

static double whole(uint64_t stream, uint64_t i, int bits)
{
    return floor(suite_double(stream, i, 0) * power_of_two(bits));
}

/* v.(v x u) = 0, in whole numbers of up to 52 and 104 digits; with one component off by one it is
 * not. */
TEST(test_vanishing)
{
    enum { DRAWN = 20000 };
    int vanish = 0;
    for (uint64_t i = 0; i < DRAWN; i++) {
        sure_vec3 v = {whole(1, i, 26), whole(2, i, 26), whole(3, i, 26)};
        sure_vec3 u = {whole(4, i, 24), whole(5, i, 24), whole(6, i, 24)};
        sure_vec3 w = cross(v, u);
        double far = power_of_two((int)(suite_bits(7, i) % 26));
        v = times(far, v);
        vector_dd across = vector_of_dd(NULL, w);
        vanish += dot_vanishes(&v, &across);
        across.x.head += v.x != 0;
        across.y.head += v.x == 0;
        ck_assert(!dot_vanishes(&v, &across) || (v.x == 0 && v.y == 0));
        across = vector_of_dd(NULL, w);
        across.z.tail = 0x1p-40;
        ck_assert(!dot_vanishes(&v, &across));
    }
    ck_assert_int_eq(vanish, DRAWN);
}

/* Heads that cancel and tails that do not, and the other way round. */
TEST(test_left_out)
{
    const struct {
        double heads[4], tails[4];
        bool zero;
    } sums[] = {{{0x1p60, 1, -0x1p60, 0}, {0, 0, 0, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0, 0, 0}, true},
                {{0, 0, 0, 0}, {0x1p60, 0x1p-60, -0x1p60, 0}, false},
                {{0, 0, 0, 0}, {0x1p60, -0x1p60, 0x1p60, 0x1p-60}, false},
                {{-0x1p60, 0, 0, 0}, {0x1p60, 0, 0x1p-60, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0x1p-9, 0, 0}, false},
                {{1, 0x1p-60, -1, 0}, {-0x1p-60, 0, 0, 0}, true}};
    for (int i = 0; i < 7; i++) {
        ck_assert_int_eq(sum_vanishes(4, sums[i].heads, sums[i].tails), sums[i].zero);
        if (sums[i].heads[3] == 0 && sums[i].tails[3] == 0)
            ck_assert_int_eq(sum_vanishes(3, sums[i].heads, sums[i].tails), sums[i].zero);
    }
}

/* What the disc's stages decide on: how far they are off as a share of what they may be. */
enum { LATE, SIGN, FOOT, SLOPE, HEIGHT, RIM, EDGE, NUMBERS };
static const char *const number_names[NUMBERS] = {"late",   "sign", "foot", "slope",
                                                  "height", "rim",  "edge"};

typedef struct {
    true_line truth;
    mpfr_t t, outside; /* of the crossing: |p|^2 - r^2 */
    flat_terms terms;
    disc_foot_terms foot;
    double late, height_error;
    double_pair slope, height;
    flat_line line;
    disc_sign rim, edge;
    bool has_line, has_rim, has_edge;
    double shares[NUMBERS], worst[NUMBERS];
} disc_numbers;

static void compute_closely(disc_numbers *of, const sure_case *c)
{
    const sure_disc *disc = &c->object.as.disc;
    vector_dd m = vector_between_dd(NULL, disc->centre, c->ray.origin);
    vector_dd d = vector_of_dd(NULL, c->ray.direction);
    of->line = flat_line_of(&c->ray, &disc->centre, &disc->normal);
    of->slope = flat_dot(&disc->normal, &d);
    of->height = flat_dot(&disc->normal, &m);
    of->height_error = SURE_CROSSING_RESIDUAL_BOUND * of->line.normal * of->line.reach;
    of->has_line = disc_in_range(&of->line, disc->radius) &&
                   filter_scales(of->line.reach, of->line.stride, of->line.normal);
    if (of->has_line && of->line.place == FLAT_CROSSES) {
        polish_point p = polish_point_of(&c->ray, &disc->centre, of->line.t);
        polish_step way = flat_step(&of->line, &p, &disc->normal);
        disc_place at = disc_place_of(of->line.t, &p, disc->radius);
        of->rim = disc_rim_sign(&c->ray, &of->line, &at, &way);
        of->has_rim = way.certain;
    } else if (of->has_line && of->line.place == FLAT_WITHIN) {
        disc_foot foot = disc_foot_of(&c->ray, disc, &of->line);
        of->edge = foot.quarter;
        of->has_edge = true;
    }
}

static void compute_numbers(const sure_case *c, void *context)
{
    disc_numbers *of = context;
    const sure_disc *disc = &c->object.as.disc;
    of->terms = flat_terms_of(&c->ray, &disc->centre, &disc->normal);
    of->foot = disc_foot_terms_of(&of->terms, &c->ray, disc->radius);
    of->late = flat_late(&of->terms, c->ray.t_min);
    of->has_line = of->has_rim = of->has_edge = false;
    if (environment_is_nearest())
        compute_closely(of, c);
}

/* |f| = |e p| by |p|^2 = outside + r^2, both as lengths. */
static double share_of_foot(const disc_numbers *of, const sure_case *c)
{
    TRUE_NUMBERS(BITS, length, rim, square);
    mpfr_abs(rim, of->truth.slope, MPFR_RNDN);
    mpfr_mul_d(rim, rim, c->object.as.disc.radius, MPFR_RNDN);
    mpfr_sqr(length, rim, MPFR_RNDN);
    mpfr_sqr(square, of->truth.slope, MPFR_RNDN);
    mpfr_fma(length, square, of->outside, length, MPFR_RNDN);
    mpfr_sqrt(length, length, MPFR_RNDN);
    mpfr_sub(length, length, rim, MPFR_RNDN);
    double off = sqrt(of->foot.square) - of->foot.rim;
    return share_of_error(length, off, of->foot.slack);
}

/* By the filter: in every environment. */
static void judge_terms(disc_numbers *of, const sure_case *c)
{
    const flat_terms *terms = &of->terms;
    double most = terms->lift + c->ray.t_min * terms->steepest;
    mpfr_mul_d(of->t, of->truth.slope, c->ray.t_min, MPFR_RNDN);
    mpfr_add(of->t, of->t, of->truth.level, MPFR_RNDN);
    if (fabs(of->late) < 0x1p1000) /* what overflows is on the right side of all that doesn't */
        of->shares[LATE] = share_of_error(of->t, of->late, SURE_CROSSING_BEHIND_BOUND * most);
    of->shares[SIGN] =
        share_of_error(of->truth.slope, terms->e, SURE_CROSSING_SIGN_BOUND * terms->steepest);
    if (mpfr_zero_p(of->truth.slope))
        return;
    crossing_of(&of->truth, of->t, of->outside);
    of->shares[FOOT] = share_of_foot(of, c);
}

/* By the second stage. */
static void judge_closely(disc_numbers *of)
{
    true_line *truth = &of->truth;
    of->shares[SLOPE] =
        share_of_pair(truth->slope, of->slope.head, of->slope.tail, of->line.e_error);
    of->shares[HEIGHT] =
        share_of_pair(truth->level, of->height.head, of->height.tail, of->height_error);
    if (of->has_rim) {
        crossing_of(truth, of->t, of->outside);
        of->shares[RIM] = share_of_error(of->outside, of->rim.value, of->rim.error);
    }
    if (of->has_edge)
        of->shares[EDGE] = share_of_error(truth->discriminant, of->edge.value, of->edge.error);
}

static void judge_numbers(const sure_case *c, void *context)
{
    disc_numbers *of = context;
    true_line_set(&of->truth, c);
    for (int i = 0; i < NUMBERS; i++)
        of->shares[i] = 0;
    if (of->foot.in_range)
        judge_terms(of, c);
    if (of->has_line)
        judge_closely(of);
    for (int i = 0; i < NUMBERS; i++) {
        of->worst[i] = fmax(of->worst[i], of->shares[i]);
        case_require(c, of->shares[i] <= 1, number_names[i]);
    }
}

/* Uphill for each of them, in every environment, from a case near what decides. */
static void climb_to(disc_numbers *of, int number, uint64_t start)
{
    enum { STEPS = 100 };
    sure_case best = near_case(SURE_SHAPE_DISC, start, &of->truth);
    double most = 0;
    for (uint64_t i = 0; i < STEPS; i++) {
        sure_case next = i == 0 ? best : case_changed(&best, start * STEPS + i, 52);
        if (i % 14 == 13)
            next.ray.t_min = bits_changed(best.ray.t_min, start * STEPS + i, 52);
        double before = of->worst[number];
        of->worst[number] = 0;
        if (case_is_valid(&next))
            in_each_environment(&next, compute_numbers, judge_numbers, of);
        double share = of->worst[number];
        of->worst[number] = fmax(share, before);
        if (share >= most) {
            most = share;
            best = next;
        }
    }
}

TEST(test_numbers)
{
    disc_numbers of = {.has_line = false};
    (void)disc_edge_closely, (void)disc_crossing_closely; /* not by themselves */
    true_line_init(&of.truth, BITS);
    mpfr_inits2(BITS, of.t, of.outside, (mpfr_ptr)NULL);
    in_each_regime(SURE_SHAPE_DISC, compute_numbers, judge_numbers, &of);
    in_each_near(SURE_SHAPE_DISC, compute_numbers, judge_numbers, &of);
    for (int i = 0; i < NUMBERS * 8; i++)
        climb_to(&of, i % NUMBERS, (uint64_t)i);
    true_line_clear(&of.truth);
    mpfr_clears(of.t, of.outside, (mpfr_ptr)NULL);
    printf("disc    worst error/bound:");
    for (int i = 0; i < NUMBERS; i++)
        printf("  %s %.3f", number_names[i], of.worst[i]);
    printf("\n");
}

SUITE("planar")
