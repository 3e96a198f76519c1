#include "filter_suite.h"

#include "../../src/cases/regimes.h"
#include "suite.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif

enum { CASES = 400, SEED = 20, ENVIRONMENTS = 5, CLIMBS = 40, STEPS = 1000 };

static const char *const environment_names[ENVIRONMENTS] = {"nearest", "up", "down", "to zero",
                                                            "nearest, flushed"};

static void enter(int which)
{
    static const int modes[ENVIRONMENTS] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO,
                                            FE_TONEAREST};
    fesetround(modes[which]);
#ifdef __SSE2_MATH__
    if (which == ENVIRONMENTS - 1)
        _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

void filter_triple_init(filter_triple v)
{
    for (int i = 0; i < 3; i++)
        mpfr_init2(v[i], FILTER_BITS);
}

void filter_triple_clear(filter_triple v)
{
    for (int i = 0; i < 3; i++)
        mpfr_clear(v[i]);
}

void filter_triple_set(filter_triple v, sure_vec3 from, sure_vec3 to)
{
    const double ends[3][2] = {{from.x, to.x}, {from.y, to.y}, {from.z, to.z}};
    for (int i = 0; i < 3; i++) {
        mpfr_set_d(v[i], ends[i][1], MPFR_RNDN);
        mpfr_sub_d(v[i], v[i], ends[i][0], MPFR_RNDN);
    }
}

void filter_triple_dot(mpfr_t dot, filter_triple v, filter_triple w)
{
    mpfr_t term;
    mpfr_init2(term, FILTER_BITS);
    mpfr_set_zero(dot, 1);
    for (int i = 0; i < 3; i++) {
        mpfr_mul(term, v[i], w[i], MPFR_RNDN);
        mpfr_add(dot, dot, term, MPFR_RNDN);
    }
    mpfr_clear(term);
}

static bool is_valid(const sure_case *c)
{
    return sure_object_check(&c->ray, &c->object) == SURE_FIELD_NONE;
}

/* Valid but for the range, which a chord says nothing about. */
static bool has_valid_line(const sure_case *c)
{
    sure_ray line = c->ray;
    line.t_min = 0;
    line.t_max = INFINITY;
    return sure_object_check(&line, &c->object) == SURE_FIELD_NONE;
}

void filter_in_each(const sure_case *c, filter_compute *what, filter_compute *judge, void *context)
{
    filter_compute *volatile compute = what; /* out of the compiler's sight */
    for (int e = 0; e < ENVIRONMENTS; e++) {
        fenv_t saved;
        fegetenv(&saved);
        enter(e);
        compute(c, context);
        fesetenv(&saved);
        judge(c, context);
    }
}

void filter_each(sure_shape shape, filter_compute *what, filter_compute *judge, void *context)
{
    for (int r = 0; r < REGIMES; r++) {
        for (uint64_t i = 0; regime_applies(shape, (regime)r) && i < CASES; i++) {
            sure_case c = regime_case(shape, (regime)r, SEED, i);
            if (is_valid(&c))
                filter_in_each(&c, what, judge, context);
        }
    }
}

/* One case's truth and what was answered. */
typedef struct {
    const filter_subject *subject;
    const sure_case *asked;
    const char *environment;
    bool exists;
    mpfr_t ends[2];
    filter_verdict line, range;
    filter_interval chord;
    filter_end first;
    bool polished;
    double t;
    double worst, worst_limit;
    long uncertain, unpolished, all;
} promise;

static void ask(promise *p, bool nearest)
{
    p->line = p->range = p->subject->filter(p->asked, &p->chord);
    p->polished = false;
    if (p->line == FILTER_INTERVAL)
        p->range = filter_first(&p->chord, &p->asked->ray, &p->first);
    if (p->range == FILTER_INTERVAL && nearest)
        p->polished = p->subject->polish(p->asked, &p->first, &p->t);
}

static void complain(const promise *p, const char *what)
{
    char line[CASE_LINE_MAX];
    case_print(p->asked, line);
    ck_abort_msg("%s, rounding %s: %s", what, p->environment, line);
}

static void require(const promise *p, bool holds, const char *what)
{
    if (!holds)
        complain(p, what);
}

/* |t - t*| / error. */
static double share_of_error(double t, mpfr_t truth, double error)
{
    mpfr_t off;
    mpfr_init2(off, FILTER_BITS);
    mpfr_sub_d(off, truth, t, MPFR_RNDN);
    mpfr_div_d(off, off, error, MPFR_RNDN);
    double share = fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return share;
}

/* error |d| / (2^-24 (|o - place| + size)). */
static double share_of_limit(const promise *p, double error)
{
    filter_triple m, d;
    mpfr_t most, step;
    filter_triple_init(m);
    filter_triple_init(d);
    mpfr_inits2(FILTER_BITS, most, step, (mpfr_ptr)NULL);
    filter_triple_set(m, p->subject->place(p->asked), p->asked->ray.origin);
    filter_triple_set(d, (sure_vec3){0, 0, 0}, p->asked->ray.direction);
    filter_triple_dot(most, m, m);
    filter_triple_dot(step, d, d);
    mpfr_sqrt(most, most, MPFR_RNDN);
    mpfr_add_d(most, most, p->subject->size(p->asked), MPFR_RNDN);
    mpfr_sqrt(step, step, MPFR_RNDN);
    mpfr_mul_d(step, step, error, MPFR_RNDN);
    mpfr_div(step, step, most, MPFR_RNDN);
    double share = mpfr_get_d(step, MPFR_RNDA) * 0x1p24;
    mpfr_clears(most, step, (mpfr_ptr)NULL);
    filter_triple_clear(m);
    filter_triple_clear(d);
    return share;
}

static void judge_end(promise *p, const filter_end *end, mpfr_t truth)
{
    double share = share_of_error(end->t, truth, end->error);
    double limit = share_of_limit(p, end->error);
    p->worst = share > p->worst ? share : p->worst;
    p->worst_limit = limit > p->worst_limit ? limit : p->worst_limit;
    require(p, share <= 1, "beyond the bound");
    require(p, limit <= 1, "beyond the limit");
}

/* The first end in the range, 0 or 1, or -1. */
static int true_first(promise *p)
{
    const sure_ray *ray = &p->asked->ray;
    for (int i = 0; i < 2 && p->exists; i++) {
        if (mpfr_cmp_d(p->ends[i], ray->t_min) >= 0)
            return mpfr_cmp_d(p->ends[i], ray->t_max) <= 0 ? i : -1;
    }
    return -1;
}

static void judge_promise(promise *p)
{
    p->all++;
    p->uncertain += p->range == FILTER_UNCERTAIN;
    if (p->line == FILTER_MISS)
        require(p, !p->exists, "a line that is no miss");
    if (p->line == FILTER_INTERVAL) {
        require(p, p->exists, "a line that is no hit");
        judge_end(p, &p->chord.enter, p->ends[0]);
        judge_end(p, &p->chord.leave, p->ends[1]);
    }
    int first = true_first(p);
    if (p->range == FILTER_MISS)
        require(p, first < 0, "no miss");
    if (p->range != FILTER_INTERVAL)
        return;
    require(p, first >= 0, "no hit");
    require(p, share_of_error(p->first.t, p->ends[first], p->first.error) <= 1, "the other end");
    if (p->polished)
        require(p, p->t == mpfr_get_d(p->ends[first], MPFR_RNDN), "wrongly rounded");
}

void filter_promises(const filter_subject *subject)
{
    promise p = {.subject = subject};
    mpfr_inits2(FILTER_BITS, p.ends[0], p.ends[1], (mpfr_ptr)NULL);
    void (*volatile asking)(promise *, bool) = ask;
    for (int r = 0; r < REGIMES; r++) {
        if (!regime_applies(subject->shape, (regime)r))
            continue;
        p.all = p.uncertain = p.unpolished = 0;
        p.worst = p.worst_limit = 0;
        for (uint64_t i = 0; i < CASES; i++) {
            sure_case c = regime_case(subject->shape, (regime)r, SEED, i);
            bool valid = is_valid(&c);
            p.asked = &c;
            p.exists = has_valid_line(&c) && subject->truth(&c, p.ends[0], p.ends[1]);
            for (int e = 0; e < ENVIRONMENTS; e++) {
                fenv_t saved;
                p.environment = environment_names[e];
                fegetenv(&saved);
                enter(e);
                asking(&p, e == 0 || e == ENVIRONMENTS - 1);
                fesetenv(&saved);
                require(&p, valid || p.range == FILTER_UNCERTAIN, "invalid");
                judge_promise(&p);
                p.unpolished += e == 0 && p.range == FILTER_INTERVAL && !p.polished;
            }
        }
        if ((regime)r == REGIME_TYPICAL)
            ck_assert(p.uncertain == 0 && p.unpolished == 0);
        printf("%-7s %-13s error/bound %.3f  error/limit %.3f  uncertain %.1f %%  unpolished %ld\n",
               sure_shape_name(subject->shape), regime_name((regime)r), p.worst, p.worst_limit,
               100. * (double)p.uncertain / (double)p.all, p.unpolished);
    }
    mpfr_clears(p.ends[0], p.ends[1], (mpfr_ptr)NULL);
}

/* One of ray's and object's numbers, t_min and t_max excepted, with other low bits. */
static sure_case changed(const sure_case *c, uint64_t draw)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(c->object.shape) - 2, at = (int)(draw % (uint64_t)count);
    case_to_numbers(c, numbers);
    double *x = &numbers[at < 6 ? at : at + 2];
    *x = double_of(bits_of(*x) ^ suite_bits(31, draw) >> (12 + suite_bits(32, draw) % 52));
    return case_from_numbers(c->object.shape, numbers);
}

/* The greater share of the two ends; 0 where there is no chord. */
static double share_at(promise *p, const sure_case *c, int environment)
{
    fenv_t saved;
    void (*volatile asking)(promise *, bool) = ask;
    p->asked = c;
    p->environment = environment_names[environment];
    fegetenv(&saved);
    enter(environment);
    asking(p, false);
    fesetenv(&saved);
    if (p->line != FILTER_INTERVAL)
        return 0;
    require(p, p->subject->truth(c, p->ends[0], p->ends[1]), "a line that is no hit");
    double first = share_of_error(p->chord.enter.t, p->ends[0], p->chord.enter.error);
    double second = share_of_error(p->chord.leave.t, p->ends[1], p->chord.leave.error);
    require(p, first <= 1 && second <= 1, "beyond the bound");
    return fmax(first, second);
}

void filter_search(const filter_subject *subject)
{
    promise p = {.subject = subject};
    double worst = 0;
    mpfr_inits2(FILTER_BITS, p.ends[0], p.ends[1], (mpfr_ptr)NULL);
    for (int i = 0; i < CLIMBS; i++) {
        regime from = i % 2 == 0 ? REGIME_TYPICAL : REGIME_GRAZING;
        int environment = 1 + i / 2 % 3;
        sure_case best = regime_case(subject->shape, from, SEED, (uint64_t)i);
        double most = share_at(&p, &best, environment);
        for (int k = 0; k < STEPS; k++) {
            sure_case next = changed(&best, suite_bits(30, (uint64_t)(i * STEPS + k)));
            double share = share_at(&p, &next, environment);
            if (share >= most) {
                most = share;
                best = next;
            }
        }
        worst = fmax(worst, most);
    }
    printf("%-7s searched      error/bound %.3f\n", sure_shape_name(subject->shape), worst);
    mpfr_clears(p.ends[0], p.ends[1], (mpfr_ptr)NULL);
}

/* (t + step - t*) / error */
static double share_of_step(double t, polish_step way, mpfr_t truth)
{
    mpfr_t off;
    mpfr_init2(off, FILTER_BITS);
    mpfr_sub_d(off, truth, t, MPFR_RNDN);
    mpfr_sub_d(off, off, way.step, MPFR_RNDN);
    mpfr_div_d(off, off, way.error, MPFR_RNDN);
    double share = fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return share;
}

void filter_steps(const filter_subject *subject)
{
    static const regime regimes[] = {REGIME_TYPICAL, REGIME_GRAZING, REGIME_FAR, REGIME_INTEGERS};
    mpfr_t ends[2];
    double worst = 0;
    long certain = 0;
    mpfr_inits2(FILTER_BITS, ends[0], ends[1], (mpfr_ptr)NULL);
    for (uint64_t i = 0; i < 40 * CASES; i++) {
        sure_case c = regime_case(subject->shape, regimes[i % 4], SEED, i / 4);
        if (!subject->truth(&c, ends[0], ends[1]))
            continue;
        bool second = suite_bits(33, i) % 2 != 0;
        double t = mpfr_get_d(ends[second], MPFR_RNDN);
        t += t * suite_double(34, i, 0) * power_of_two(-(int)(suite_bits(35, i) % 60));
        end_kind at = subject->shape != SURE_SHAPE_SPHERE ? END_BASE : second ? END_MORE : END_LESS;
        polish_step way = subject->step(&c, at, t);
        if (!way.certain)
            continue;
        certain++;
        double share = share_of_step(t, way, ends[second]);
        worst = fmax(worst, share);
        ck_assert_double_le(share, 1);
    }
    ck_assert_int_ge(certain, CASES);
    printf("%-7s %ld steps   error/bound %.3f\n", sure_shape_name(subject->shape), certain, worst);
    mpfr_clears(ends[0], ends[1], (mpfr_ptr)NULL);
}
