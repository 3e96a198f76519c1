/* What the disc's first two stages decide on, held against numbers wide enough to be exact. */
#include "../../src/shapes/disc/disc_close.h"
#include "planar_suite.h"

/* How far they are off as a share of what they may be. */
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
        of->edge = disc_edge_sign(&foot);
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
    mpfr_t length, rim, square;
    mpfr_inits2(PLANAR_BITS, length, rim, square, (mpfr_ptr)NULL);
    mpfr_abs(rim, of->truth.slope, MPFR_RNDN);
    mpfr_mul_d(rim, rim, c->object.as.disc.radius, MPFR_RNDN);
    mpfr_sqr(length, rim, MPFR_RNDN);
    mpfr_sqr(square, of->truth.slope, MPFR_RNDN);
    mpfr_fma(length, square, of->outside, length, MPFR_RNDN);
    mpfr_sqrt(length, length, MPFR_RNDN);
    mpfr_sub(length, length, rim, MPFR_RNDN);
    double off = sqrt(of->foot.square) - of->foot.rim;
    double share = share_of_error(length, off, of->foot.slack);
    mpfr_clears(length, rim, square, (mpfr_ptr)NULL);
    return share;
}

/* By the filter: in every environment. */
static void judge_terms(disc_numbers *of, const sure_case *c)
{
    const flat_terms *terms = &of->terms;
    double most = terms->normal * (terms->reach + c->ray.t_min * terms->stride);
    mpfr_mul_d(of->t, of->truth.slope, c->ray.t_min, MPFR_RNDN);
    mpfr_add(of->t, of->t, of->truth.level, MPFR_RNDN);
    if (fabs(of->late) < 0x1p1000) /* what overflows is on the right side of all that doesn't */
        of->shares[LATE] = share_of_error(of->t, of->late, SURE_CROSSING_BEHIND_BOUND * most);
    of->shares[SIGN] =
        share_of_error(of->truth.slope, terms->e, SURE_CROSSING_SIGN_BOUND * terms->steepest);
    if (mpfr_zero_p(of->truth.slope))
        return;
    planar_crossing(&of->truth, of->t, of->outside);
    of->shares[FOOT] = share_of_foot(of, c);
}

static double share_of_pair(disc_numbers *of, mpfr_t truth, double_pair value, double error)
{
    mpfr_sub_d(of->t, truth, value.tail, MPFR_RNDN);
    return share_of_error(of->t, value.head, error);
}

/* By the second stage. */
static void judge_closely(disc_numbers *of)
{
    true_line *truth = &of->truth;
    of->shares[SLOPE] = share_of_pair(of, truth->slope, of->slope, of->line.e_error);
    of->shares[HEIGHT] = share_of_pair(of, truth->level, of->height, of->height_error);
    if (of->has_rim) {
        planar_crossing(truth, of->t, of->outside);
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
    sure_case best = planar_near(SURE_SHAPE_DISC, start, &of->truth);
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
    (void)disc_edge_closely, (void)disc_crossing_closely; /* not by themselves: test_planar */
    true_line_init(&of.truth, PLANAR_BITS);
    mpfr_inits2(PLANAR_BITS, of.t, of.outside, (mpfr_ptr)NULL);
    in_each_regime(SURE_SHAPE_DISC, compute_numbers, judge_numbers, &of);
    planar_each_near(SURE_SHAPE_DISC, compute_numbers, judge_numbers, &of);
    for (int i = 0; i < NUMBERS * 8; i++)
        climb_to(&of, i % NUMBERS, (uint64_t)i);
    true_line_clear(&of.truth);
    mpfr_clears(of.t, of.outside, (mpfr_ptr)NULL);
    printf("disc    worst error/bound:");
    for (int i = 0; i < NUMBERS; i++)
        printf("  %s %.3f", number_names[i], of.worst[i]);
    printf("\n");
}

SUITE("disc numbers")
