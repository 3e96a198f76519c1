/* SPDX-License-Identifier: MIT */
#include "piece.h"

#include "../support/test_shape.h"
#include "complain.h"
#include "cpu_time.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#define MEASURED 3e7 /* ns a pair */

typedef struct {
    const plan_wish *wish;
    double weights; /* of all pairs; then what is one's: cases and ns of each */
    index_range cases[SURE_SHAPES][REGIMES];
    double cost[SURE_SHAPES][REGIMES];
    double total, share; /* ns: of all, and of a piece */
    double taken, left;  /* by this piece, and what it still takes */
    uint64_t pieces;
    coverage piece;
    json_t *lines;
} planning;

static bool is_wanted(const plan_wish *wish, sure_shape shape, regime which)
{
    return (wish->shape < 0 || (sure_shape)wish->shape == shape) &&
           (wish->regime < 0 || (regime)wish->regime == which);
}

/* A sixth where nearly each answer takes numbers of thousands of digits. */
static double weight_of(sure_shape shape, regime which)
{
    bool longest =
        test_shape_of(shape)->long_numbers && (which == REGIME_BITS || which == REGIME_DEGENERATE);
    return longest ? 1.0 / 6 : 1;
}

static bool weigh(void *context, sure_shape shape, regime which)
{
    planning *p = context;
    if (is_wanted(p->wish, shape, which))
        p->weights += weight_of(shape, which);
    return true;
}

/* Nobody is told of broken promises: whoever works the piece off will be. */
static void unheard(const sure_case *question, const char *what)
{
    (void)question;
    (void)what;
}

/* What a case takes, by the first of them. */
static double measured(const plan_wish *wish, sure_shape shape, regime which, index_range cases)
{
    pair_tally unused = {0};
    worst_calls calls[WORST_QUESTIONS] = {{0}};
    double began = cpu_time(), taken = 0;
    uint64_t i = cases.first;
    for (; i < cases.end && taken < MEASURED; i++) {
        sure_case question = regime_case(shape, which, wish->seed, i);
        campaign_check(wish->against, &question, campaign_more_of(i), unheard, &unused);
        worst_look(&question, which, i, calls);
        taken = cpu_time() - began;
    }
    return taken / (double)(i - cases.first);
}

static bool measure(void *context, sure_shape shape, regime which)
{
    planning *p = context;
    const plan_wish *wish = p->wish;
    if (!is_wanted(wish, shape, which))
        return true;
    index_range *cases = &p->cases[shape][which];
    double number = ceil(wish->cases * weight_of(shape, which) / p->weights);
    if (wish->after && wish->after->done.of[shape][which].count > 0) {
        const index_ranges *there = &wish->after->done.of[shape][which];
        cases->first = there->of[there->count - 1].end;
    }
    if (number > (double)(RANGES_MOST - cases->first))
        return false;
    cases->end = cases->first + (uint64_t)number;
    p->cost[shape][which] = measured(wish, shape, which, *cases);
    p->total += p->cost[shape][which] * number;
    return true;
}

static bool append_pair(void *context, sure_shape shape, regime which)
{
    planning *p = context;
    json_t *line = json_array_get(p->lines, json_array_size(p->lines) - 1);
    if (p->piece.of[shape][which].count > 0)
        json_array_append_new(json_object_get(line, "cases"), pair_json(&p->piece, shape, which));
    return true;
}

static void end_piece(planning *p)
{
    json_int_t number = (json_int_t)json_array_size(p->lines);
    json_array_append_new(p->lines, json_pack("{s:I, s:f, s:[]}", "piece", number, "seconds",
                                              1e-9 * p->taken, "cases"));
    each_pair(append_pair, p);
    coverage_free(&p->piece);
    p->taken = 0;
    p->left += p->share; /* the rest, or what was too much, goes with the next */
}

/* Cuts a pair's cases where a piece is full; the last one takes the rest. */
static bool cut(void *context, sure_shape shape, regime which)
{
    planning *p = context;
    index_range *rest = &p->cases[shape][which];
    double cost = p->cost[shape][which];
    while (rest->first < rest->end) {
        bool last = json_array_size(p->lines) >= p->pieces;
        double fits = last ? INFINITY : fmax(1, ceil(p->left / cost));
        bool all = fits >= (double)(rest->end - rest->first);
        uint64_t end = all ? rest->end : rest->first + (uint64_t)fits;
        if (!ranges_add(&p->piece.of[shape][which], (index_range){rest->first, end}))
            return false;
        p->taken += cost * (double)(end - rest->first);
        p->left -= cost * (double)(end - rest->first);
        rest->first = end;
        if (p->left <= 0 && !last)
            end_piece(p);
    }
    return true;
}

static bool has_cases(void *context, sure_shape shape, regime which)
{
    const planning *p = context;
    return p->piece.of[shape][which].count == 0;
}

plan_state plan_write(const plan_wish *wish, const char *path, FILE *messages)
{
    static planning p;
    campaign_record like;
    record_begin(wish->against, wish->seed, &like);
    p = (planning){.wish = wish, .lines = json_array()};
    json_array_append(p.lines, like.asked);
    record_free(&like);
    each_pair(weigh, &p);
    if (p.weights == 0 || !each_pair(measure, &p)) {
        json_decref(p.lines);
        complain(messages, path,
                 p.weights == 0 ? "the shape has no such regime" : "more cases than there are");
        return PLAN_IMPOSSIBLE;
    }
    double by_time = ceil(p.total / (1e9 * wish->seconds));
    p.pieces = wish->pieces > 0 ? wish->pieces : (uint64_t)fmin(fmax(by_time, 1), 1e9);
    p.left = p.share = p.total / (double)p.pieces;
    if (!each_pair(cut, &p))
        abort();
    if (!each_pair(has_cases, &p))
        end_piece(&p);
    size_t pieces = json_array_size(p.lines) - 1;
    bool written = sealed_write(p.lines, path, messages);
    if (written)
        printf("%s: %zu pieces, %.3g s each, %.3g s in all\n", path, pieces, 1e-9 * p.share,
               1e-9 * p.total);
    return written ? PLAN_WRITTEN : PLAN_NOT_WRITTEN;
}
