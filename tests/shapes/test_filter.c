/* SPDX-License-Identifier: MIT */
/* What a first stage promises (src/stages/filter.h), held against numbers wide enough to be exact:
 * in every regime, in every rounding mode, with subnormals kept and flushed. */
#include "../support/every_case.h"
#include "../support/surroundings.h"
#include "../support/test_shape.h"
#include "../../src/stages/close.h"
#include "../../src/stages/rows.h"
#include "filters.h"

enum { BITS = 4000, CASES = 400, SEED = 20, DRAWN = 16000, HALVINGS = 70, EDGES = 4000 };

/* Of the case that is tried. */
static true_line line;
static mpfr_t first_t;

static void set_up(void)
{
    true_line_init(&line, BITS);
    mpfr_init2(first_t, BITS);
}

static void tear_down(void)
{
    true_line_clear(&line);
    mpfr_clear(first_t);
}

/* A case, what is true of it, and what was answered. */
typedef struct {
    const filter_subject *subject;
    bool exists, hits; /* the line meets the object; the ray does */
    filter_verdict told, in_range;
    filter_interval chord;
    filter_end first;
    bool walls_alone, nearest, polished;
    double rounded;
    double worst, worst_limit;
    long all, uncertain, unpolished;
    unsigned points; /* a bit each, of those where ends are */
} trial;

/* Valid but for the range, which a chord says nothing about. */
static bool has_valid_line(const sure_case *c)
{
    sure_case whole = *c;
    whole.ray.t_min = 0;
    whole.ray.t_max = INFINITY;
    return case_is_valid(&whole);
}

static void find_truth(trial *of, const sure_case *c)
{
    of->exists = of->hits = false;
    if (!has_valid_line(c))
        return;
    true_line_set(&line, c);
    of->exists = line.exists;
    of->hits = true_first(&line, first_t);
}

static bool is_plane(true_end at)
{
    return at == TRUE_BASE || at == TRUE_TOP;
}

static void ask(const sure_case *c, void *context)
{
    trial *of = context;
    const shape_row *row = row_of(&c->object);
    of->told = of->in_range = filter_line(c, &of->chord);
    of->polished = false;
    of->nearest = fegetround() == FE_TONEAREST;
    if (of->told == FILTER_INTERVAL)
        of->in_range = filter_first(&of->chord, &c->ray, &of->first);
    if (of->in_range == FILTER_INTERVAL && of->nearest)
        of->polished = polish(close_of(row)->step, row->steps, &c->ray, &c->object.as, &of->first,
                              &of->rounded);
}

/* error |d| / (2^-24 (|o - place| + size)) */
static double share_of_limit(const sure_case *c, double error)
{
    true_vector m;
    true_vector_init(m, BITS);
    TRUE_NUMBERS(BITS, most, step);
    true_vector_between(m, object_place(&c->object), c->ray.origin);
    true_dot(most, m, m);
    mpfr_sqrt(most, most, MPFR_RNDN);
    mpfr_add_d(most, most, (double)object_reach(object_place(&c->object), &c->object), MPFR_RNDN);
    mpfr_sqrt(step, line.dd, MPFR_RNDN);
    mpfr_mul_d(step, step, error, MPFR_RNDN);
    mpfr_div(step, step, most, MPFR_RNDN);
    double share = mpfr_get_d(step, MPFR_RNDA) * 0x1p24;
    true_vector_clear(m);
    return share;
}

static void require_point(const sure_case *c, const tagged_end *said, true_end at)
{
    sure_part part = at == TRUE_BASE  ? SURE_PART_BASE
                     : at == TRUE_TOP ? SURE_PART_TOP
                                      : SURE_PART_WALL;
    case_require(c, said->at == end_kind_of(at) && said->part == part, "another point");
}

static void judge_end(trial *of, const sure_case *c, int which, const filter_end *end)
{
    double share = share_of_error(line.t[which], end->t, end->error);
    double limit = share_of_limit(c, end->error);
    of->worst = fmax(of->worst, share);
    of->worst_limit = fmax(of->worst_limit, limit);
    case_require(c, share <= 1, "beyond the bound");
    case_require(c, limit <= 1, "beyond the limit");
    of->points |= 1U << line.at[which];
    if (of->subject->powers > 0)
        require_point(c, &end->end, line.at[which]);
}

static void judge(const sure_case *c, void *context)
{
    trial *of = context;
    of->all++;
    of->uncertain += of->in_range == FILTER_UNCERTAIN;
    case_require(c, case_is_valid(c) || of->in_range == FILTER_UNCERTAIN, "invalid");
    if (of->told == FILTER_MISS)
        case_require(c, !of->exists, "a line that is no miss");
    if (of->told == FILTER_INTERVAL) {
        case_require(c, of->exists, "a line that is no hit");
        judge_end(of, c, 0, &of->chord.enter);
        judge_end(of, c, 1, &of->chord.leave);
    }
    if (of->in_range == FILTER_MISS)
        case_require(c, !of->hits, "no miss");
    if (of->in_range != FILTER_INTERVAL)
        return;
    case_require(c, of->hits, "no hit");
    case_require(c, share_of_error(first_t, of->first.t, of->first.error) <= 1, "the other end");
    if (of->polished)
        case_require(c, of->rounded == mpfr_get_d(first_t, MPFR_RNDN), "wrongly rounded");
    of->unpolished += !of->polished && of->nearest;
}

/* Error/bound, error/limit, and what stayed uncertain. */
SHAPE_TEST(test_promises)
{
    sure_shape shape = (sure_shape)_i;
    trial of = {.subject = &filter_subjects[_i]};
    for (int r = 0; r < REGIMES; r++) {
        if (!regime_applies(shape, (regime)r))
            continue;
        of.all = of.uncertain = of.unpolished = 0;
        of.worst = of.worst_limit = 0;
        for (uint64_t i = 0; i < CASES; i++) {
            sure_case c = regime_case(shape, (regime)r, SEED, i);
            find_truth(&of, &c);
            in_each_environment(&c, ask, judge, &of);
        }
        if ((regime)r == REGIME_TYPICAL)
            ck_assert(of.uncertain == 0 && of.unpolished == 0);
        printf("%-8s %-13s error/bound %.3f  error/limit %.3f  uncertain %.1f %%  unpolished %ld\n",
               sure_shape_name(shape), regime_name((regime)r), of.worst, of.worst_limit,
               100. * (double)of.uncertain / (double)of.all, of.unpolished);
    }
    for (int at = TRUE_LESS; at <= TRUE_BASE && of.subject->powers > 0; at++)
        ck_assert(of.points >> at & 1);
}

static void ask_in(int surroundings, const sure_case *c, trial *of)
{
    case_compute *volatile asking = ask;
    surroundings_set(surroundings);
    asking(c, of);
    surroundings_set(0);
}

/* The greatest share of the ends, or of those on a wall. */
static double share_of_ends(const sure_case *c, int surroundings, void *context)
{
    trial *of = context;
    double most = 0;
    ask_in(surroundings, c, of);
    if (of->told != FILTER_INTERVAL)
        return 0;
    find_truth(of, c);
    case_require(c, of->exists, "a line that is no hit");
    const filter_end *ends[] = {&of->chord.enter, &of->chord.leave};
    for (int i = 0; i < 2; i++) {
        if (!of->walls_alone || ends[i]->end.part == SURE_PART_WALL)
            most = fmax(most, share_of_error(line.t[i], ends[i]->t, ends[i]->error));
    }
    case_require(c, most <= 1, "beyond the bound");
    return most;
}

static const regime climb_from[] = {REGIME_TYPICAL, REGIME_GRAZING, REGIME_AXIS_PARALLEL,
                                    REGIME_FAR, REGIME_COIN};

/* Looks for a violation of the bounds uphill; the walls', which the planes' would hide, alone. */
SHAPE_TEST(test_search)
{
    const climbing how = {climb_from, 5, 40, 1000, NULL};
    trial of = {.subject = &filter_subjects[_i]};
    for (int walls = 0; walls <= (of.subject->powers > 0); walls++) {
        of.walls_alone = walls > 0;
        printf("%-8s searched %-5s error/bound %.3f\n", sure_shape_name((sure_shape)_i),
               walls ? "walls" : "", climb((sure_shape)_i, &how, share_of_ends, &of));
    }
}

/* A step of the polish from places at all distances from an end. */
SHAPE_TEST(test_steps)
{
    static const regime regimes[] = {REGIME_TYPICAL,  REGIME_GRAZING, REGIME_FAR,  REGIME_SCALES,
                                     REGIME_INTEGERS, REGIME_NEEDLE,  REGIME_COIN, REGIME_SCALES};
    sure_shape shape = (sure_shape)_i;
    double worst[2] = {0, 0}; /* to roots, to planes */
    long certain[2] = {0, 0};
    trial of = {.subject = &filter_subjects[_i]};
    if (!filter_subjects[_i].step)
        return;
    for (uint64_t i = 0; i < DRAWN; i++) {
        if (!regime_applies(shape, regimes[i % 8]))
            continue;
        sure_case c = regime_case(shape, regimes[i % 8], SEED, i / 4);
        bool last = suite_bits(33, i) % 2 != 0;
        find_truth(&of, &c);
        true_end at = line.at[last];
        if (!of.exists || at == TRUE_ENDLESS || (line.tapers && at == TRUE_TOP))
            continue; /* no chord that meets the interior ends in an apex */
        double t = mpfr_get_d(line.t[last], MPFR_RNDN);
        t += t * suite_double(34, i, 0) * power_of_two(-(int)(suite_bits(35, i) % 60));
        polish_step way = of.subject->step(&c, end_kind_of(at), t);
        if (!way.certain)
            continue;
        mpfr_sub_d(first_t, line.t[last], t, MPFR_RNDN);
        double share = share_of_error(first_t, way.step, way.error);
        worst[is_plane(at)] = fmax(worst[is_plane(at)], share);
        certain[is_plane(at)]++;
        case_require(&c, share <= 1, "a step beyond its error");
    }
    ck_assert(line.flat || certain[0] >= CASES);
    ck_assert(certain[1] >= CASES || !(line.flat || line.capped));
    printf("%-8s steps: %ld to roots, error/bound %.3f; %ld to planes, %.3f\n",
           sure_shape_name(shape), certain[0], worst[0], certain[1], worst[1]);
}

/* The bound of the discriminant: the greatest radius at which a line is said to miss, found by
 * bisection in every rounding mode. Does it miss? */
SHAPE_TEST(test_edges)
{
    static const regime regimes[] = {REGIME_TYPICAL, REGIME_FAR, REGIME_GRAZING, REGIME_COIN};
    long edges = 0;
    trial of = {.subject = &filter_subjects[_i]};
    if (!filter_subjects[_i].body)
        return;
    for (uint64_t i = 0; i < EDGES; i++) {
        if (!regime_applies((sure_shape)_i, regimes[i % 4]))
            continue;
        sure_case c = regime_case((sure_shape)_i, regimes[i % 4], SEED, i / 4);
        int mode = (int)(i / 4 % SURROUNDINGS_MODES);
        double less = 0x1p-60, more = 0x1p60;
        double *radius = case_number(&c, case_numbers(c.object.shape) - 1);
        c.ray.t_min = 0;
        c.ray.t_max = INFINITY;
        for (int k = 0; k < HALVINGS; k++) {
            *radius = k < 10 ? sqrt(less * more) : less + (more - less) / 2;
            ask_in(mode, &c, &of);
            *(of.told == FILTER_MISS ? &less : &more) = *radius;
        }
        *radius = less;
        ask_in(mode, &c, &of);
        if (of.told != FILTER_MISS)
            continue;
        edges++;
        find_truth(&of, &c);
        case_require(&c, !of.exists, "no miss");
    }
    ck_assert_int_ge(edges, EDGES / 4);
    printf("%-8s %ld edges\n", sure_shape_name((sure_shape)_i), edges);
}

static double share_of_discriminants(const sure_case *c, int surroundings, void *context)
{
    trial *of = context;
    body_terms (*volatile find)(const sure_case *) = of->subject->body;
    double most = 0;
    surroundings_set(surroundings);
    body_terms terms = find(c);
    surroundings_set(0);
    if (!terms.found[0].told && !terms.found[1].told)
        return 0;
    true_line_set(&line, c);
    true_discriminant(of->subject, &line, first_t);
    for (int i = 0; i < 2; i++) {
        if (terms.found[i].told)
            most = fmax(most, share_of_error(first_t, terms.found[i].value, terms.found[i].error));
    }
    case_require(c, most <= 1, "a discriminant beyond its error");
    return most;
}

/* What decides is as good as it says, in all regimes and uphill. */
SHAPE_TEST(test_discriminants)
{
    const climbing how = {climb_from, 5, 60, 1000, NULL};
    double worst = 0;
    trial of = {.subject = &filter_subjects[_i]};
    if (!filter_subjects[_i].body)
        return;
    for (case_walk w = walk_regimes((sure_shape)_i, SEED, CASES); walk_next(&w);) {
        for (int e = 0; case_is_valid(&w.asked) && e < ENVIRONMENTS; e++)
            worst = fmax(worst, share_of_discriminants(&w.asked, e, &of));
    }
    printf("%-8s discriminants, error/bound %.3f, searched %.3f\n", sure_shape_name((sure_shape)_i),
           worst, climb((sure_shape)_i, &how, share_of_discriminants, &of));
}

SUITE_IN("filter", set_up, tear_down)
