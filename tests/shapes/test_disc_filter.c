/* The disc's first two stages and polish, held against exact numbers. */
#include "../support/filter_suite.h"
#include "../support/flat_suite.h"
#include "../support/suite.h"

#include "../../src/shapes/disc/disc_close.h"

static sure_vec3 place(const sure_case *c)
{
    return c->object.as.disc.centre;
}

static double radius(const sure_case *c)
{
    return c->object.as.disc.radius;
}

/* Of the line alone: as if the ray started where no crossing is behind. */
static filter_verdict line_filter(const sure_case *c, filter_interval *found)
{
    const sure_disc *disc = &c->object.as.disc;
    flat_terms of = flat_terms_of(&c->ray, &disc->centre, &disc->normal);
    filter_verdict verdict = disc_filter(&c->ray, disc, found);
    return flat_behind(&of, c->ray.t_min) ? FILTER_UNCERTAIN : verdict;
}

static bool polish(const sure_case *c, const filter_end *end, double *t)
{
    return disc_polish(&c->ray, &c->object.as.disc, end, t);
}

static polish_step step(const sure_case *c, end_kind at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.disc.centre, &c->object.as.disc.normal, t);
}

/* Is |t d + m| <= r? Leaves m changed. */
static bool reaches(const sure_case *c, mpfr_t t, filter_triple m, filter_triple d)
{
    mpfr_t r, square;
    mpfr_inits2(FILTER_BITS, r, square, (mpfr_ptr)NULL);
    for (int i = 0; i < 3; i++)
        mpfr_fma(m[i], t, d[i], m[i], MPFR_RNDN);
    filter_triple_dot(square, m, m);
    mpfr_set_d(r, c->object.as.disc.radius, MPFR_RNDN);
    mpfr_sqr(r, r, MPFR_RNDN);
    bool within = mpfr_lessequal_p(square, r);
    mpfr_clears(r, square, (mpfr_ptr)NULL);
    return within;
}

/* t = -N.m / N.d, where that is within the circle. A chord in the disc's plane is no crossing. */
static bool truth(const sure_case *c, mpfr_t enter, mpfr_t leave)
{
    const sure_vec3 zero = {0, 0, 0};
    filter_triple m, d, n;
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_init(n);
    filter_triple_set(m, c->object.as.disc.centre, c->ray.origin);
    filter_triple_set(d, zero, c->ray.direction);
    filter_triple_set(n, zero, c->object.as.disc.normal);
    filter_triple_dot(enter, n, m);
    filter_triple_dot(leave, n, d);
    bool crosses = !mpfr_zero_p(leave);
    mpfr_div(enter, enter, leave, MPFR_RNDN);
    mpfr_neg(enter, enter, MPFR_RNDN);
    mpfr_set(leave, enter, MPFR_RNDN);
    bool hits = crosses && reaches(c, enter, m, d);
    filter_triple_clear(m);
    filter_triple_clear(d);
    filter_triple_clear(n);
    return hits;
}

static const filter_subject subject = {SURE_SHAPE_DISC, place, radius, line_filter,
                                       polish,          step,  truth};

static sure_vec3 normal(const sure_case *c)
{
    return c->object.as.disc.normal;
}

static filter_verdict filter(const sure_case *c, filter_interval *found)
{
    return disc_filter(&c->ray, &c->object.as.disc, found);
}

static filter_verdict closely(const sure_case *c, t_wanted wanted, sure_hit *hit)
{
    return disc_close(&c->ray, &c->object.as.disc, wanted, hit);
}

static const flat_subject flat = {SURE_SHAPE_DISC, place, normal, radius, filter, closely};

START_TEST(test_promises)
{
    filter_promises(&subject);
}
END_TEST

START_TEST(test_steps)
{
    filter_steps(&subject);
}
END_TEST

START_TEST(test_search)
{
    filter_search(&subject);
}
END_TEST

START_TEST(test_hits)
{
    flat_promises(&flat);
}
END_TEST

/* Discs that are crossed at about t_min and about the rim, to within roundings. */
START_TEST(test_rims)
{
    flat_near(&flat);
}
END_TEST

/* The numbers that decide, and how far they are off as a share of what they may be. */
enum { LATE, SIGN, FOOT, SLOPE, HEIGHT, RIM, EDGE, NUMBERS };
static const char *const number_names[NUMBERS] = {"late",   "sign", "foot", "slope",
                                                  "height", "rim",  "edge"};

typedef struct {
    flat_truth truth;
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
static double share_of_foot(disc_numbers *of, const sure_case *c, mpfr_t outside)
{
    mpfr_t length, rim;
    mpfr_inits2(FLAT_BITS, length, rim, (mpfr_ptr)NULL);
    mpfr_abs(rim, of->truth.e, MPFR_RNDN);
    mpfr_mul_d(rim, rim, c->object.as.disc.radius, MPFR_RNDN);
    mpfr_sqr(length, rim, MPFR_RNDN);
    mpfr_sqr(of->truth.room, of->truth.e, MPFR_RNDN);
    mpfr_fma(length, of->truth.room, outside, length, MPFR_RNDN);
    mpfr_sqrt(length, length, MPFR_RNDN);
    mpfr_sub(length, length, rim, MPFR_RNDN);
    double off = sqrt(of->foot.square) - of->foot.rim;
    double share = flat_share(length, off, of->foot.slack, of->truth.room);
    mpfr_clears(length, rim, (mpfr_ptr)NULL);
    return share;
}

/* By the filter: in every environment. */
static void judge_terms(disc_numbers *of, const sure_case *c, mpfr_t value)
{
    const flat_terms *terms = &of->terms;
    double most = terms->normal * (terms->reach + c->ray.t_min * terms->stride);
    mpfr_mul_d(value, of->truth.e, c->ray.t_min, MPFR_RNDN);
    mpfr_add(value, value, of->truth.h, MPFR_RNDN);
    if (fabs(of->late) < 0x1p1000) /* what overflows is on the right side of all that doesn't */
        of->shares[LATE] =
            flat_share(value, of->late, SURE_CROSSING_BEHIND_BOUND * most, of->truth.room);
    of->shares[SIGN] = flat_share(of->truth.e, terms->e, SURE_CROSSING_SIGN_BOUND * terms->steepest,
                                  of->truth.room);
    if (mpfr_sgn(of->truth.e) == 0)
        return;
    flat_truth_at_crossing(&of->truth, value);
    of->shares[FOOT] = share_of_foot(of, c, value);
}

static double share_of_pair(mpfr_t truth, double_pair value, double error, mpfr_t room)
{
    mpfr_sub_d(room, truth, value.tail, MPFR_RNDN);
    return flat_share(room, value.head, error, room);
}

/* By the second stage. */
static void judge_closely(disc_numbers *of, mpfr_t value)
{
    mpfr_ptr room = of->truth.room;
    of->shares[SLOPE] = share_of_pair(of->truth.e, of->slope, of->line.e_error, room);
    of->shares[HEIGHT] = share_of_pair(of->truth.h, of->height, of->height_error, room);
    if (of->has_rim) {
        flat_truth_at_crossing(&of->truth, value);
        of->shares[RIM] = flat_share(value, of->rim.value, of->rim.error, room);
    }
    if (of->has_edge) {
        mpfr_mul(room, of->truth.a, of->truth.c, MPFR_RNDN);
        mpfr_sqr(value, of->truth.b, MPFR_RNDN);
        mpfr_sub(value, value, room, MPFR_RNDN);
        of->shares[EDGE] = flat_share(value, of->edge.value, of->edge.error, room);
    }
}

static void judge_numbers(const sure_case *c, void *context)
{
    disc_numbers *of = context;
    mpfr_t value;
    mpfr_init2(value, FLAT_BITS);
    flat_truth_set(&of->truth, &flat, c);
    for (int i = 0; i < NUMBERS; i++)
        of->shares[i] = 0;
    if (of->foot.in_range)
        judge_terms(of, c, value);
    if (of->has_line)
        judge_closely(of, value);
    mpfr_clear(value);
    for (int i = 0; i < NUMBERS; i++) {
        of->worst[i] = fmax(of->worst[i], of->shares[i]);
        flat_complain(c, of->shares[i] <= 1, number_names[i]);
    }
}

/* Uphill for each of them: from a case of the regimes or a drawn one, its numbers' low bits changed
 * at random, what grows is kept. */
static void climb(disc_numbers *of, int number, uint64_t start)
{
    enum { STEPS = 100 };
    sure_case best = flat_drawn(SURE_SHAPE_DISC, start);
    double most = 0;
    flat_set_near(&of->truth, &flat, &best, start);
    for (uint64_t i = 0; i < STEPS; i++) {
        sure_case next = i == 0 ? best : flat_changed(&best, start * STEPS + i);
        double before = of->worst[number];
        of->worst[number] = 0;
        if (sure_object_check(&next.ray, &next.object) == SURE_FIELD_NONE)
            filter_in_each(&next, compute_numbers, judge_numbers, of);
        double share = of->worst[number];
        of->worst[number] = fmax(share, before);
        if (share >= most) {
            most = share;
            best = next;
        }
    }
}

START_TEST(test_numbers)
{
    disc_numbers of = {.has_line = false};
    flat_truth_init(&of.truth);
    filter_each(SURE_SHAPE_DISC, compute_numbers, judge_numbers, &of);
    flat_each_near(&flat, compute_numbers, judge_numbers, &of);
    for (int i = 0; i < NUMBERS * 8; i++)
        climb(&of, i % NUMBERS, (uint64_t)i);
    flat_truth_clear(&of.truth);
    printf("disc    worst error/bound:");
    for (int i = 0; i < NUMBERS; i++)
        printf("  %s %.3f", number_names[i], of.worst[i]);
    printf("\n");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("disc filter");
    TCase *all = tcase_create("promises");
    tcase_add_test(all, test_promises);
    tcase_add_test(all, test_search);
    tcase_add_test(all, test_steps);
    tcase_add_test(all, test_hits);
    tcase_add_test(all, test_rims);
    tcase_add_test(all, test_numbers);
    tcase_set_timeout(all, 300);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}
