/* SPDX-License-Identifier: MIT */
#include "every_case.h"

#include "surroundings.h"

#include "../../src/numbers/bits.h"

enum { CASES = 400, SEED = 20, RANGE = 2 };

static int environment; /* last computed in */

void case_require(const sure_case *c, bool holds, const char *what)
{
    ck_assert_msg(holds, "%s, rounding %s: %s", what, surroundings_name(environment), case_text(c));
}

bool case_is_valid(const sure_case *c)
{
    return sure_object_check(&c->ray, &c->object) == SURE_FIELD_NONE;
}

double share_of_error(mpfr_t truth, double value, double error)
{
    TRUE_NUMBERS(mpfr_get_prec(truth), off);
    mpfr_sub_d(off, truth, value, MPFR_RNDN);
    if (!mpfr_zero_p(off))
        mpfr_div_d(off, off, error, MPFR_RNDN);
    return fabs(mpfr_get_d(off, MPFR_RNDA));
}

double share_of_pair(mpfr_t truth, double head, double tail, double error)
{
    TRUE_NUMBERS(mpfr_get_prec(truth), off);
    mpfr_sub_d(off, truth, tail, MPFR_RNDN);
    return share_of_error(off, head, error);
}

case_walk walk_regimes(sure_shape shape, uint64_t seed, uint64_t count)
{
    return (case_walk){.shape = shape, .seed = seed, .count = count, .index = UINT64_MAX};
}

bool walk_next(case_walk *w)
{
    for (w->index++; w->which < REGIMES; w->which++, w->index = 0) {
        if (w->index < w->count && regime_applies(w->shape, w->which)) {
            w->asked = regime_case(w->shape, w->which, w->seed, w->index);
            return true;
        }
    }
    return false;
}

void in_each_environment(const sure_case *c, case_compute *compute, case_compute *judge,
                         void *context)
{
    case_compute *volatile hidden = compute;
    for (int e = 0; e < ENVIRONMENTS; e++) {
        environment = e;
        surroundings_set(e);
        hidden(c, context);
        surroundings_set(0);
        judge(c, context);
    }
}

void in_each_regime(sure_shape shape, case_compute *compute, case_compute *judge, void *context)
{
    for (case_walk w = walk_regimes(shape, SEED, CASES); walk_next(&w);) {
        if (case_is_valid(&w.asked))
            in_each_environment(&w.asked, compute, judge, context);
    }
}

double bits_changed(double x, uint64_t draw, int most)
{
    int bits = 1 + (int)(suite_bits(42, draw) % (uint64_t)most);
    return double_of(bits_of(x) ^ suite_bits(41, draw) >> (64 - bits));
}

sure_case case_changed(const sure_case *c, uint64_t draw, int most)
{
    sure_case changed = *c;
    int count = case_numbers(c->object.shape) - RANGE;
    int at = (int)(suite_bits(43, draw) % (uint64_t)count);
    double *x = case_number(&changed, at < AT_T_MIN ? at : at + RANGE);
    *x = bits_changed(*x, draw, most);
    return changed;
}

static double score_in(int surroundings, case_score *score, const sure_case *c, void *context)
{
    environment = surroundings;
    double result = score(c, surroundings, context);
    surroundings_set(0);
    return result;
}

double climb(sure_shape shape, const climbing *how, case_score *score, void *context)
{
    double greatest = 0;
    for (int i = 0, started = 0; started < how->climbs; i++) {
        regime from = how->from[i % how->regimes];
        if (!regime_applies(shape, from))
            continue;
        int surroundings = started++ % SURROUNDINGS_MODES;
        sure_case best = regime_case(shape, from, SEED, (uint64_t)i);
        best = how->start ? how->start(&best, i) : best;
        double most = score_in(surroundings, score, &best, context);
        for (int k = 0; k < how->steps; k++) {
            sure_case next = case_changed(&best, (uint64_t)(i * how->steps + k), 52);
            double reached = score_in(surroundings, score, &next, context);
            if (reached >= most) {
                most = reached;
                best = next;
            }
        }
        greatest = fmax(greatest, most);
    }
    return greatest;
}
