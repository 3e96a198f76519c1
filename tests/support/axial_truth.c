#include "axial_truth.h"

#include "../../src/numbers/bits.h"
#include "../../src/cases/regimes.h"
#include "suite.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>

enum { CASES = 4000, SEED = 21, MODES = 4, HALVINGS = 70, CLIMBS = 60, STEPS = 2000 };

void axial_truth_init(axial_truth *truth)
{
    mpfr_inits2(FILTER_BITS, truth->ends[0], truth->ends[1], (mpfr_ptr)NULL);
}

void axial_truth_clear(axial_truth *truth)
{
    mpfr_clears(truth->ends[0], truth->ends[1], (mpfr_ptr)NULL);
}

/* A from base or apex, m the same to o; the products of these and d. */
typedef struct {
    mpfr_t height, speed, depth, dd, md, mm, rr;
} products;

static void products_init(products *p)
{
    mpfr_inits2(FILTER_BITS, p->height, p->speed, p->depth, p->dd, p->md, p->mm, p->rr,
                (mpfr_ptr)NULL);
}

static void products_clear(products *p)
{
    mpfr_clears(p->height, p->speed, p->depth, p->dd, p->md, p->mm, p->rr, (mpfr_ptr)NULL);
}

static void products_set(products *p, const sure_case *asked)
{
    const sure_object *object = &asked->object;
    bool cone = object->shape == SURE_SHAPE_CONE;
    sure_vec3 from = cone ? object->as.cone.apex : object->as.cylinder.base;
    sure_vec3 to = cone ? object->as.cone.base : object->as.cylinder.top;
    filter_triple axis, m, d;
    filter_triple_init(axis);
    filter_triple_init(m);
    filter_triple_init(d);
    filter_triple_set(axis, from, to);
    filter_triple_set(m, from, asked->ray.origin);
    filter_triple_set(d, (sure_vec3){0, 0, 0}, asked->ray.direction);
    filter_triple_dot(p->height, axis, axis);
    filter_triple_dot(p->speed, axis, d);
    filter_triple_dot(p->depth, axis, m);
    filter_triple_dot(p->dd, d, d);
    filter_triple_dot(p->md, m, d);
    filter_triple_dot(p->mm, m, m);
    mpfr_set_d(p->rr, cone ? object->as.cone.radius : object->as.cylinder.radius, MPFR_RNDN);
    mpfr_sqr(p->rr, p->rr, MPFR_RNDN);
    filter_triple_clear(axis);
    filter_triple_clear(m);
    filter_triple_clear(d);
}

/* q = x y z - k v w, all products of Gram's matrix or the shape's factors. */
static void difference(mpfr_t q, mpfr_t x, mpfr_t y, mpfr_t k, mpfr_t v, mpfr_t w)
{
    mpfr_t other;
    mpfr_init2(other, FILTER_BITS);
    mpfr_mul(q, x, y, MPFR_RNDN);
    mpfr_mul(other, v, w, MPFR_RNDN);
    mpfr_mul(other, other, k, MPFR_RNDN);
    mpfr_sub(q, q, other, MPFR_RNDN);
    mpfr_clear(other);
}

/* a t^2 + 2 b t + c with heights squared: x = H q.q - k (A.q)^2 - H r^2 for the cylinder, k = 1; x
 * = H^2 q.q - (H + r^2) (A.q)^2 for the cone. */
static void wall_quadratic(const products *from, bool cone, mpfr_t a, mpfr_t b, mpfr_t c)
{
    products p = *from;
    mpfr_t k, factor, squares;
    mpfr_inits2(FILTER_BITS, k, factor, squares, (mpfr_ptr)NULL);
    mpfr_set_ui(k, 1, MPFR_RNDN);
    mpfr_set(factor, p.height, MPFR_RNDN);
    mpfr_set(squares, p.mm, MPFR_RNDN);
    if (cone) {
        mpfr_add(k, p.height, p.rr, MPFR_RNDN);
        mpfr_sqr(factor, p.height, MPFR_RNDN);
    } else {
        mpfr_sub(squares, p.mm, p.rr, MPFR_RNDN);
    }
    difference(a, factor, p.dd, k, p.speed, p.speed);
    difference(b, factor, p.md, k, p.speed, p.depth);
    difference(c, factor, squares, k, p.depth, p.depth);
    mpfr_clears(k, factor, squares, (mpfr_ptr)NULL);
}

static void wall_quarter(mpfr_t quarter, mpfr_t a, mpfr_t b, mpfr_t c)
{
    mpfr_t one;
    mpfr_init2(one, FILTER_BITS);
    mpfr_set_ui(one, 1, MPFR_RNDN);
    difference(quarter, b, b, one, a, c);
    mpfr_clear(one);
}

/* Both roots in order; false without real ones. Entry: a is not 0. */
static bool wall_roots(mpfr_t a, mpfr_t b, mpfr_t c, mpfr_t roots[2])
{
    mpfr_t quarter;
    mpfr_init2(quarter, FILTER_BITS);
    wall_quarter(quarter, a, b, c);
    bool real = mpfr_sgn(quarter) >= 0;
    mpfr_sqrt(quarter, quarter, MPFR_RNDN);
    mpfr_neg(b, b, MPFR_RNDN);
    mpfr_sub(roots[0], b, quarter, MPFR_RNDN);
    mpfr_add(roots[1], b, quarter, MPFR_RNDN);
    mpfr_div(roots[0], roots[0], a, MPFR_RNDN);
    mpfr_div(roots[1], roots[1], a, MPFR_RNDN);
    if (mpfr_sgn(a) < 0)
        mpfr_swap(roots[0], roots[1]);
    mpfr_clear(quarter);
    return real;
}

static void replace(axial_truth *truth, int end, mpfr_t t, end_kind at)
{
    int order = mpfr_cmp(t, truth->ends[end]);
    if (end == 0 ? order >= 0 : order <= 0) {
        mpfr_set(truth->ends[end], t, MPFR_RNDN);
        truth->at[end] = at;
    }
}

/* Is the height A.m of a line across the axis from 0 to H? Otherwise the planes leave nothing. */
static void at_one_height(const products *p, axial_truth *truth)
{
    if (mpfr_sgn(p->depth) < 0 || mpfr_cmp(p->depth, p->height) > 0)
        mpfr_set_inf(truth->ends[0], 1);
}

/* What the planes leave; `base` is of the base, which for the cone is at the height H. */
static void between_planes(const products *p, bool cone, axial_truth *truth)
{
    if (mpfr_zero_p(p->speed)) {
        at_one_height(p, truth);
        return;
    }
    mpfr_t zero, full;
    mpfr_inits2(FILTER_BITS, zero, full, (mpfr_ptr)NULL);
    mpfr_neg(zero, p->depth, MPFR_RNDN);
    mpfr_add(full, zero, p->height, MPFR_RNDN);
    mpfr_div(zero, zero, p->speed, MPFR_RNDN);
    mpfr_div(full, full, p->speed, MPFR_RNDN);
    int rises = mpfr_sgn(p->speed) > 0;
    replace(truth, !rises, zero, cone ? END_TOP : END_BASE);
    replace(truth, rises, full, cone ? END_BASE : END_TOP);
    mpfr_clears(zero, full, (mpfr_ptr)NULL);
}

/* Between the roots, or for a cone and a < 0 from the kept nappe's root on, or up to it. */
static void in_wall(const products *p, int leading, mpfr_t roots[2], axial_truth *truth)
{
    int rises = mpfr_sgn(p->speed) > 0;
    truth->at[0] = truth->at[1] = END_ENDLESS;
    mpfr_set_inf(truth->ends[0], -1);
    mpfr_set_inf(truth->ends[1], 1);
    if (leading > 0) {
        replace(truth, 0, roots[0], END_LESS);
        replace(truth, 1, roots[1], END_MORE);
    } else {
        replace(truth, !rises, roots[rises], rises ? END_MORE : END_LESS);
    }
}

bool axial_truth_of(const sure_case *asked, axial_truth *truth)
{
    bool cone = asked->object.shape == SURE_SHAPE_CONE, meets = false;
    products p;
    mpfr_t a, b, c, roots[2];
    products_init(&p);
    mpfr_inits2(FILTER_BITS, a, b, c, roots[0], roots[1], (mpfr_ptr)NULL);
    products_set(&p, asked);
    wall_quadratic(&p, cone, a, b, c);
    if (!mpfr_zero_p(a) && wall_roots(a, b, c, roots)) {
        in_wall(&p, mpfr_sgn(a), roots, truth);
        between_planes(&p, cone, truth);
        meets = mpfr_cmp(truth->ends[0], truth->ends[1]) <= 0;
    }
    mpfr_clears(a, b, c, roots[0], roots[1], (mpfr_ptr)NULL);
    products_clear(&p);
    return meets;
}

/* |end - (t + step)| / error */
static double share_of(double t, double step, double error, mpfr_t end)
{
    mpfr_t off;
    mpfr_init2(off, FILTER_BITS);
    mpfr_sub_d(off, end, t, MPFR_RNDN);
    mpfr_sub_d(off, off, step, MPFR_RNDN);
    mpfr_div_d(off, off, error, MPFR_RNDN);
    double share = fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return share;
}

void axial_steps(sure_shape shape, polish_step (*step)(const sure_case *, end_kind at, double t))
{
    static const regime regimes[] = {REGIME_TYPICAL, REGIME_GRAZING, REGIME_FAR,
                                     REGIME_NEEDLE,  REGIME_COIN,    REGIME_INTEGERS};
    axial_truth truth;
    double worst[2] = {0, 0};
    long certain[2] = {0, 0};
    axial_truth_init(&truth);
    for (uint64_t i = 0; i < 6 * CASES; i++) {
        sure_case c = regime_case(shape, regimes[i % 6], SEED, i / 6);
        if (!axial_truth_of(&c, &truth))
            continue;
        bool last = suite_bits(36, i) % 2 != 0;
        if (shape == SURE_SHAPE_CONE && truth.at[last] == END_TOP)
            continue; /* the apex: no end of a chord that meets the interior */
        double t = mpfr_get_d(truth.ends[last], MPFR_RNDN);
        t += t * suite_double(37, i, 0) * power_of_two(-(int)(suite_bits(38, i) % 60));
        polish_step way = step(&c, truth.at[last], t);
        if (!way.certain)
            continue;
        bool plane = truth.at[last] == END_BASE || truth.at[last] == END_TOP;
        double share = share_of(t, way.step, way.error, truth.ends[last]);
        worst[plane] = fmax(worst[plane], share);
        certain[plane]++;
        char line[CASE_LINE_MAX];
        case_print(&c, line);
        ck_assert_msg(share <= 1, "off by %g errors from %a: %s", share, t, line);
    }
    ck_assert_int_ge(certain[0], CASES / 4);
    ck_assert_int_ge(certain[1], CASES / 4);
    printf("%-8s steps: %ld to walls, error/bound %.4f; %ld to planes, %.4f\n",
           sure_shape_name(shape), certain[0], worst[0], certain[1], worst[1]);
    axial_truth_clear(&truth);
}

static sure_part part_of(end_kind at)
{
    return at == END_BASE ? SURE_PART_BASE : at == END_TOP ? SURE_PART_TOP : SURE_PART_WALL;
}

static void require_point(const sure_case *c, const tagged_end *said, end_kind at)
{
    char line[CASE_LINE_MAX];
    case_print(c, line);
    ck_assert_msg(said->at == at && said->part == part_of(at), "another point: %s", line);
}

void axial_points(const filter_subject *subject)
{
    long chords[4] = {0, 0, 0, 0};
    axial_truth truth;
    axial_truth_init(&truth);
    for (uint64_t i = 0; i < CASES; i++) {
        sure_case c = regime_case(subject->shape, REGIME_TYPICAL, SEED, i);
        filter_interval found;
        if (subject->filter(&c, &found) != FILTER_INTERVAL)
            continue;
        ck_assert(axial_truth_of(&c, &truth));
        require_point(&c, &found.enter.end, truth.at[0]);
        require_point(&c, &found.leave.end, truth.at[1]);
        chords[found.enter.end.at]++;
        chords[found.leave.end.at]++;
    }
    for (int at = END_LESS; at <= END_BASE; at++)
        ck_assert_int_ge(chords[at], CASES / 64);
    axial_truth_clear(&truth);
}

static const int modes[MODES] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
static const regime climb_from[] = {REGIME_TYPICAL, REGIME_AXIS_PARALLEL, REGIME_FAR, REGIME_COIN};

/* Out of the compiler's sight, in one rounding mode. */
static filter_verdict filter_in(const filter_subject *subject, const sure_case *c, int mode,
                                filter_interval *found)
{
    filter_verdict (*volatile filter)(const sure_case *, filter_interval *) = subject->filter;
    fesetround(modes[mode]);
    filter_verdict verdict = filter(c, found);
    fesetround(FE_TONEAREST);
    return verdict;
}

static double *radius_of(sure_case *c)
{
    return c->object.shape == SURE_SHAPE_CONE ? &c->object.as.cone.radius
                                              : &c->object.as.cylinder.radius;
}

void axial_edges(const filter_subject *subject)
{
    static const regime regimes[] = {REGIME_TYPICAL, REGIME_FAR, REGIME_COIN};
    long edges = 0;
    axial_truth truth;
    axial_truth_init(&truth);
    for (uint64_t i = 0; i < CASES; i++) {
        sure_case c = regime_case(subject->shape, regimes[i % 3], SEED, i / 3);
        int mode = (int)(i / 3 % MODES);
        filter_interval unused;
        double less = 0x1p-60, more = 0x1p60;
        c.ray.t_min = 0;
        c.ray.t_max = INFINITY;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = k < 10 ? sqrt(less * more) : less + (more - less) / 2;
            *radius_of(&c) = middle;
            bool misses = filter_in(subject, &c, mode, &unused) == FILTER_MISS;
            *(misses ? &less : &more) = middle;
        }
        *radius_of(&c) = less;
        if (filter_in(subject, &c, mode, &unused) != FILTER_MISS)
            continue;
        char line[CASE_LINE_MAX];
        case_print(&c, line);
        edges++;
        ck_assert_msg(!axial_truth_of(&c, &truth), "no miss, mode %d: %s", mode, line);
    }
    ck_assert_int_ge(edges, CASES / 4);
    printf("%-8s %ld edges\n", sure_shape_name(subject->shape), edges);
    axial_truth_clear(&truth);
}

/* The greater share of the ends that are on the wall. */
static double wall_share(const filter_subject *subject, const sure_case *c, int mode,
                         axial_truth *truth)
{
    filter_interval found;
    if (filter_in(subject, c, mode, &found) != FILTER_INTERVAL)
        return 0;
    const filter_end *ends[2] = {&found.enter, &found.leave};
    double worst = 0;
    ck_assert(axial_truth_of(c, truth));
    for (int i = 0; i < 2; i++) {
        if (ends[i]->end.part == SURE_PART_WALL)
            worst = fmax(worst, share_of(ends[i]->t, 0, ends[i]->error, truth->ends[i]));
    }
    return worst;
}

/* One of ray's and object's numbers, t_min and t_max excepted, with other low bits. */
static sure_case changed(const sure_case *c, uint64_t draw)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(c->object.shape) - 2, at = (int)(draw % (uint64_t)count);
    case_to_numbers(c, numbers);
    double *x = &numbers[at < 6 ? at : at + 2];
    *x = double_of(bits_of(*x) ^ suite_bits(41, draw) >> (12 + suite_bits(42, draw) % 52));
    return case_from_numbers(c->object.shape, numbers);
}

/* (b^2 - a c) / H for the cylinder, over H^2 for the cone. */
static void true_discriminant(const sure_case *c, mpfr_t value)
{
    bool cone = c->object.shape == SURE_SHAPE_CONE;
    products p;
    mpfr_t a, b, e;
    products_init(&p);
    mpfr_inits2(FILTER_BITS, a, b, e, (mpfr_ptr)NULL);
    products_set(&p, c);
    wall_quadratic(&p, cone, a, b, e);
    wall_quarter(value, a, b, e);
    mpfr_div(value, value, p.height, MPFR_RNDN);
    if (cone)
        mpfr_div(value, value, p.height, MPFR_RNDN);
    mpfr_clears(a, b, e, (mpfr_ptr)NULL);
    products_clear(&p);
}

static double discriminant_share(axial_discriminant *terms, const sure_case *c, int mode,
                                 mpfr_t truth)
{
    axial_discriminant *volatile compute = terms;
    double value, certain;
    fesetround(modes[mode]);
    bool told = compute(c, &value, &certain);
    fesetround(FE_TONEAREST);
    if (!told)
        return 0;
    true_discriminant(c, truth);
    return share_of(value, 0, sqrt(certain), truth);
}

void axial_discriminants(sure_shape shape, axial_discriminant *terms)
{
    double worst = 0;
    mpfr_t truth;
    mpfr_init2(truth, FILTER_BITS);
    for (int i = 0; i < CLIMBS; i++) {
        int mode = i % MODES;
        sure_case best = regime_case(shape, climb_from[i / MODES % 4], SEED, (uint64_t)i);
        double most = discriminant_share(terms, &best, mode, truth);
        for (int k = 0; k < STEPS; k++) {
            sure_case next = changed(&best, suite_bits(43, (uint64_t)(i * STEPS + k)));
            double share = discriminant_share(terms, &next, mode, truth);
            if (share >= most) {
                most = share;
                best = next;
            }
        }
        worst = fmax(worst, most);
        ck_assert_double_le(worst, 1);
    }
    printf("%-8s searched discriminants, error/bound %.3f\n", sure_shape_name(shape), worst);
    mpfr_clear(truth);
}

void axial_search(const filter_subject *subject)
{
    double worst = 0;
    axial_truth truth;
    axial_truth_init(&truth);
    for (int i = 0; i < CLIMBS; i++) {
        int mode = i % MODES;
        sure_case best = regime_case(subject->shape, climb_from[i / MODES % 4], SEED, (uint64_t)i);
        double most = wall_share(subject, &best, mode, &truth);
        for (int k = 0; k < STEPS; k++) {
            sure_case next = changed(&best, suite_bits(40, (uint64_t)(i * STEPS + k)));
            double share = wall_share(subject, &next, mode, &truth);
            if (share >= most) {
                most = share;
                best = next;
            }
        }
        worst = fmax(worst, most);
        ck_assert_double_le(worst, 1);
    }
    printf("%-8s searched walls, error/bound %.3f\n", sure_shape_name(subject->shape), worst);
    axial_truth_clear(&truth);
}
