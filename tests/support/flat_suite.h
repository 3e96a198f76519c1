/* The first two stages of a flat shape, held against numbers wide enough to be exact: the first hit
 * itself, not the chord alone. */
#ifndef SUPPORT_FLAT_SUITE_H
#define SUPPORT_FLAT_SUITE_H

#include "filter_suite.h"
#include "suite.h"

#include "../../src/shapes/planar/flat_close.h"

#include <stdio.h>

enum { FLAT_BITS = 12000 };

typedef struct {
    sure_shape shape;
    sure_vec3 (*place)(const sure_case *);
    sure_vec3 (*normal)(const sure_case *);
    double (*radius)(const sure_case *); /* INFINITY for the plane */
    filter_verdict (*filter)(const sure_case *, filter_interval *);
    filter_verdict (*close)(const sure_case *, t_wanted, sure_hit *);
} flat_subject;

/* A line: e = N.d, h = N.m, and a t^2 + 2 b t + c the square of the distance from the place, less
 * r^2. */
typedef struct {
    mpfr_t e, h, a, b, c, t, room;
} flat_truth;

static void flat_truth_init(flat_truth *of)
{
    mpfr_inits2(FLAT_BITS, of->e, of->h, of->a, of->b, of->c, of->t, of->room, (mpfr_ptr)NULL);
}

static void flat_truth_clear(flat_truth *of)
{
    mpfr_clears(of->e, of->h, of->a, of->b, of->c, of->t, of->room, (mpfr_ptr)NULL);
}

static void flat_truth_set(flat_truth *of, const flat_subject *subject, const sure_case *c)
{
    const sure_vec3 zero = {0, 0, 0};
    double r = subject->radius(c);
    filter_triple m, d, n;
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_init(n);
    filter_triple_set(m, subject->place(c), c->ray.origin);
    filter_triple_set(d, zero, c->ray.direction);
    filter_triple_set(n, zero, subject->normal(c));
    const struct {
        mpfr_ptr dot;
        mpfr_t *v, *w;
    } dots[] = {{of->e, n, d}, {of->h, n, m}, {of->a, d, d}, {of->b, m, d}, {of->c, m, m}};
    for (int i = 0; i < 5; i++) {
        mpfr_mul(dots[i].dot, dots[i].v[0], dots[i].w[0], MPFR_RNDN);
        mpfr_fma(dots[i].dot, dots[i].v[1], dots[i].w[1], dots[i].dot, MPFR_RNDN);
        mpfr_fma(dots[i].dot, dots[i].v[2], dots[i].w[2], dots[i].dot, MPFR_RNDN);
    }
    mpfr_set_d(of->room, r, MPFR_RNDN);
    mpfr_sqr(of->room, of->room, MPFR_RNDN);
    mpfr_sub(of->c, of->c, of->room, MPFR_RNDN);
    filter_triple_clear(m);
    filter_triple_clear(d);
    filter_triple_clear(n);
}

/* a n^2 + 2 b n k + c k^2: the sign of the distance's square less r^2, at n / k. */
static int flat_truth_outside(const flat_truth *of, mpfr_t n, mpfr_t k)
{
    mpfr_t value, term;
    mpfr_inits2(FLAT_BITS, value, term, (mpfr_ptr)NULL);
    mpfr_mul(value, of->a, n, MPFR_RNDN);
    mpfr_mul(term, of->b, k, MPFR_RNDN);
    mpfr_mul_2ui(term, term, 1, MPFR_RNDN);
    mpfr_add(value, value, term, MPFR_RNDN);
    mpfr_mul(value, value, n, MPFR_RNDN);
    mpfr_sqr(term, k, MPFR_RNDN);
    mpfr_fma(value, of->c, term, value, MPFR_RNDN);
    int sign = mpfr_sgn(value);
    mpfr_clears(value, term, (mpfr_ptr)NULL);
    return sign;
}

static int flat_truth_outside_at(const flat_truth *of, double t)
{
    mpfr_t n, one;
    mpfr_inits2(FLAT_BITS, n, one, (mpfr_ptr)NULL);
    mpfr_set_d(n, t, MPFR_RNDN);
    mpfr_set_ui(one, 1, MPFR_RNDN);
    int sign = flat_truth_outside(of, n, one);
    mpfr_clears(n, one, (mpfr_ptr)NULL);
    return sign;
}

/* Sign of slope * x + offset. */
static int flat_truth_line(mpfr_t slope, double x, mpfr_t offset)
{
    mpfr_t value;
    mpfr_init2(value, FLAT_BITS);
    mpfr_mul_d(value, slope, x, MPFR_RNDN);
    mpfr_add(value, value, offset, MPFR_RNDN);
    int sign = mpfr_sgn(value);
    mpfr_clear(value);
    return sign;
}

/* Within the disc's plane: the first point in the range of the line's chord in the circle. */
static bool flat_truth_edge(flat_truth *of, const sure_ray *ray)
{
    mpfr_mul(of->room, of->a, of->c, MPFR_RNDN);
    mpfr_sqr(of->t, of->b, MPFR_RNDN);
    mpfr_sub(of->room, of->t, of->room, MPFR_RNDN);
    if (mpfr_sgn(of->room) < 0)
        return false;
    int outside = flat_truth_outside_at(of, ray->t_min);
    int side = flat_truth_line(of->a, ray->t_min, of->b); /* of t_min - vertex */
    mpfr_set_d(of->t, ray->t_min, MPFR_RNDN);
    if (outside <= 0)
        return true;
    if (side > 0 || (isfinite(ray->t_max) && flat_truth_outside_at(of, ray->t_max) > 0 &&
                     flat_truth_line(of->a, ray->t_max, of->b) < 0))
        return false;
    mpfr_sqrt(of->room, of->room, MPFR_RNDN);
    mpfr_add(of->t, of->b, of->room, MPFR_RNDN);
    mpfr_neg(of->t, of->t, MPFR_RNDN);
    mpfr_div(of->t, of->t, of->a, MPFR_RNDN);
    return true;
}

/* Is there a hit? Its t. Entry: valid. */
static bool flat_truth_first(flat_truth *of, const flat_subject *subject, const sure_case *c)
{
    const sure_ray *ray = &c->ray;
    bool disc = isfinite(subject->radius(c));
    int steep = mpfr_sgn(of->e);
    if (steep == 0 && mpfr_sgn(of->h) != 0)
        return false;
    if (steep == 0 && disc)
        return flat_truth_edge(of, ray);
    mpfr_set_d(of->t, ray->t_min, MPFR_RNDN);
    if (steep == 0)
        return true;
    if (flat_truth_line(of->e, ray->t_min, of->h) * steep > 0 ||
        (isfinite(ray->t_max) && flat_truth_line(of->e, ray->t_max, of->h) * steep < 0))
        return false;
    mpfr_neg(of->room, of->h, MPFR_RNDN);
    mpfr_div(of->t, of->room, of->e, MPFR_RNDN);
    return !disc || flat_truth_outside(of, of->room, of->e) <= 0;
}

/* What was answered. */
typedef struct {
    const flat_subject *subject;
    flat_truth truth;
    filter_verdict filter, close[2]; /* by t_wanted */
    filter_end first;
    sure_hit hits[2];
    long all, close_asked, close_answers;
    double worst;
} flat_answers;

static void flat_complain(const sure_case *c, bool holds, const char *what)
{
    char line[CASE_LINE_MAX];
    if (holds)
        return;
    case_print(c, line);
    ck_abort_msg("%s: %s", what, line);
}

static double flat_share(mpfr_t truth, double value, double error, mpfr_t room)
{
    mpfr_sub_d(room, truth, value, MPFR_RNDN);
    if (mpfr_zero_p(room))
        return 0;
    mpfr_div_d(room, room, error, MPFR_RNDN);
    return fabs(mpfr_get_d(room, MPFR_RNDA));
}

static void flat_ask(const sure_case *c, void *context)
{
    flat_answers *of = context;
    filter_interval found;
    of->filter = of->subject->filter(c, &found);
    if (of->filter == FILTER_INTERVAL)
        of->filter = filter_first(&found, &c->ray, &of->first);
    of->close[0] = of->close[1] = FILTER_UNCERTAIN;
    for (int wanted = 0; wanted < 2 && environment_is_nearest(); wanted++)
        of->close[wanted] = of->subject->close(c, (t_wanted)wanted, &of->hits[wanted]);
}

static void flat_judge_hit(flat_answers *of, const sure_case *c, const sure_hit *hit)
{
    double share = flat_share(of->truth.t, hit->t, hit->t_error, of->truth.room);
    of->worst = fmax(of->worst, share);
    flat_complain(c, share <= 1, "beyond the bound");
    flat_complain(c, hit->t >= c->ray.t_min && hit->t <= c->ray.t_max, "beyond the range");
}

static void flat_judge(const sure_case *c, void *context)
{
    flat_answers *of = context;
    flat_truth_set(&of->truth, of->subject, c);
    bool hits = flat_truth_first(&of->truth, of->subject, c);
    of->all++;
    flat_complain(c, of->filter != FILTER_MISS || !hits, "the filter: no miss");
    flat_complain(c, of->filter != FILTER_INTERVAL || hits, "the filter: no hit");
    for (int wanted = 0; wanted < 2; wanted++) {
        flat_complain(c, of->close[wanted] != FILTER_MISS || !hits, "closely: no miss");
        flat_complain(c, of->close[wanted] != FILTER_INTERVAL || hits, "closely: no hit");
    }
    of->close_asked += of->filter == FILTER_UNCERTAIN;
    of->close_answers += of->filter == FILTER_UNCERTAIN && of->close[0] != FILTER_UNCERTAIN;
    if (of->close[T_CERTAIN] == FILTER_INTERVAL)
        flat_judge_hit(of, c, &of->hits[T_CERTAIN]);
    if (of->close[T_EXACT] == FILTER_INTERVAL) {
        const sure_hit *hit = &of->hits[T_EXACT];
        double rounded = mpfr_get_d(of->truth.t, MPFR_RNDN);
        flat_complain(c, hit->t == rounded && signbit(hit->t) == 0, "wrongly rounded");
        flat_complain(c, hit->t_error == 0 || hit->t_error == half_ulp(hit->t), "half ulp");
    }
}

/* |p|^2 - r^2 where the plane is crossed. */
static inline void flat_truth_at_crossing(flat_truth *of, mpfr_t outside)
{
    mpfr_neg(of->t, of->h, MPFR_RNDN);
    mpfr_div(of->t, of->t, of->e, MPFR_RNDN);
    mpfr_mul(outside, of->a, of->t, MPFR_RNDN);
    mpfr_add(outside, outside, of->b, MPFR_RNDN);
    mpfr_add(outside, outside, of->b, MPFR_RNDN);
    mpfr_fma(outside, outside, of->t, of->c, MPFR_RNDN);
}

/* A case drawn at random: all mantissas full, a part of the lines within the plane z = 0, from up
 * to 2^reach radii away, slopes down to 2^-slope. */
static sure_case flat_drawn(sure_shape shape, uint64_t i)
{
    enum { AT_T_MIN = 6, AT_PLACE = 8, AT_NORMAL = 11, AT_RADIUS = 14 };
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

/* t_min and the radius set to what the line has, but for a few ulps. */
static void flat_set_near(flat_truth *truth, const flat_subject *subject, sure_case *c, uint64_t i)
{
    mpfr_t outside;
    mpfr_init2(outside, FLAT_BITS);
    flat_truth_set(truth, subject, c);
    if (mpfr_sgn(truth->e) != 0) {
        flat_truth_at_crossing(truth, outside);
    } else {
        mpfr_div(truth->t, truth->b, truth->a, MPFR_RNDN);
        mpfr_mul(outside, truth->t, truth->b, MPFR_RNDN);
        mpfr_neg(truth->t, truth->t, MPFR_RNDN);
        mpfr_sub(outside, truth->c, outside, MPFR_RNDN);
    }
    double t = mpfr_get_d(truth->t, MPFR_RNDN);
    double ulps = (double)suite_integer(64, i, 4) * 0x1p-53;
    if (suite_bits(65, i) % 2 == 0 && t > 0)
        c->ray.t_min = t + t * ulps * power_of_two((int)(suite_bits(66, i) % 8));
    if (isfinite(subject->radius(c))) {
        double r = subject->radius(c);
        mpfr_set_d(truth->room, r, MPFR_RNDN);
        mpfr_fma(outside, truth->room, truth->room, outside, MPFR_RNDN);
        mpfr_sqrt(outside, outside, MPFR_RNDN);
        r = mpfr_get_d(outside, MPFR_RNDN);
        c->object.as.disc.radius = r + r * (double)suite_integer(67, i, 4) * 0x1p-53;
    }
    mpfr_clear(outside);
}

/* One of its numbers, t_max excepted, with other low bits. */
static inline sure_case flat_changed(const sure_case *c, uint64_t draw)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(c->object.shape) - 1,
        at = (int)(suite_bits(68, draw) % (unsigned)count);
    case_to_numbers(c, numbers);
    double *x = &numbers[at < 7 ? at : at + 1];
    *x = double_of(bits_of(*x) ^ suite_bits(69, draw) >> (12 + suite_bits(70, draw) % 52));
    return case_from_numbers(c->object.shape, numbers);
}

enum { FLAT_DRAWN = 3000 };

/* Calls both for such cases in each environment. */
static void flat_each_near(const flat_subject *subject, filter_compute *what, filter_compute *judge,
                           void *context)
{
    flat_truth truth;
    flat_truth_init(&truth);
    for (uint64_t i = 0; i < FLAT_DRAWN; i++) {
        sure_case c = flat_drawn(subject->shape, i);
        flat_set_near(&truth, subject, &c, i);
        if (sure_object_check(&c.ray, &c.object) == SURE_FIELD_NONE)
            filter_in_each(&c, what, judge, context);
    }
    flat_truth_clear(&truth);
}

/* Every regime, every environment. */
static void flat_promises(const flat_subject *subject)
{
    flat_answers of = {.subject = subject};
    flat_truth_init(&of.truth);
    filter_each(subject->shape, flat_ask, flat_judge, &of);
    flat_truth_clear(&of.truth);
    printf("%-7s closely       error/bound %.3f  of %ld left by the filter %ld answered\n",
           sure_shape_name(subject->shape), of.worst, of.close_asked, of.close_answers);
    fflush(stdout);
    ck_assert_int_gt(of.close_answers, of.all / 10);
}

/* Crossings about t_min and about the rim. */
static void flat_near(const flat_subject *subject)
{
    flat_answers of = {.subject = subject};
    flat_truth_init(&of.truth);
    flat_each_near(subject, flat_ask, flat_judge, &of);
    flat_truth_clear(&of.truth);
    printf("%-7s near          error/bound %.3f  of %ld left by the filter %ld answered\n",
           sure_shape_name(subject->shape), of.worst, of.close_asked, of.close_answers);
    fflush(stdout);
    ck_assert_int_gt(of.close_answers, of.all / 20);
}

#endif
