/* SPDX-License-Identifier: MIT */
#include "judging.h"

#include "../support/progress.h"
#include "shrink.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double worst_size(int kind, const example *one, precision in)
{
    if (kind == WORST_T)
        return example_ulps(one, in);
    return error_normal_ulps(error_normal(one->given.normal, one->truth.normal), in);
}

static const example *example_of(const judging_row *row, int kind)
{
    const verdict *sum = &row->sum;
    if (kind < FAULTS_WITH_MARGIN && row->looked_at.most[kind] > 0)
        return &row->looked_at.widest[kind];
    return kind == WORST_T        ? &sum->worst_t
           : kind == WORST_NORMAL ? &sum->worst_normal
                                  : &sum->faulty[kind];
}

/* The widest margin of a decision, the first of another fault, the largest of an error. */
static bool choose(judging *self, const judging_row *rows, int count, int kind, worst_case *chosen)
{
    double most = -1;
    for (int i = 0; i < count; i++) {
        const example *one = example_of(&rows[i], kind);
        precision in = judging_asked(self)->answers_in[rows[i].asks][rows[i].shape];
        double margin = kind < FAULTS_WITH_MARGIN ? rows[i].looked_at.most[kind] : 0;
        double size = !one->found ? -1 : kind < FAULTS ? margin : worst_size(kind, one, in);
        if (size <= most)
            continue;
        most = size;
        *chosen = (worst_case){kind, rows[i].asks, rows[i].shape, rows[i].which, in, margin, *one};
    }
    return most >= 0;
}

/* So many cases may be tried to make one simple: one by one each better case is gone on from at
 * once; of several at a time most are asked for nothing. */
#define TRIES_ONE_BY_ONE 1000
#define TRIES_BY_SEVERAL 2000

/* What a simpler case must still do. */
typedef struct {
    judging *self;
    worst_case *best;
    double least; /* the size of an error */
    int tries;    /* left, */
    double until; /* by progress_clock */
} aim;

/* A wrong decision stays as far from right. */
static bool is_as_wide(const aim *at, const example *one)
{
    const worst_case *best = at->best;
    if (best->margin == 0)
        return true;
    const movement unit = margin_way(&one->question, judging_unit(at->self), best->in);
    const movement way = movement_times(&unit, best->margin);
    return margin_beyond(&one->question, (fault)best->kind, &one->given, &way);
}

static bool does_it(const aim *at, const example *one)
{
    int kind = at->best->kind;
    bool invalid = at->best->found.truth.status == SURE_INVALID;
    if (!one->found || invalid != (one->truth.status == SURE_INVALID))
        return false;
    if (kind < FAULTS)
        return (judging_faults(at->self, one) & FAULT_BIT(kind)) != 0 && is_as_wide(at, one);
    const bool right_part = (judging_faults(at->self, one) & FAULT_BIT(FAULT_WRONG_PART)) == 0;
    return fault_is_hit(&one->truth, &one->given) &&
           (kind == WORST_T || (one->given.has_normal && right_part)) &&
           worst_size(kind, one, at->best->in) >= at->least;
}

/* What hangs takes all its time, and a program that ends has to start anew: from the first one on
 * the tries take no longer than one may. */
static void mind_the_time(aim *at, const example *one)
{
    const candidate *asked = judging_asked(at->self);
    const reply_kind kind = one->given.kind;
    if (kind == REPLY_HUNG || (asked->is_program && kind >= REPLY_CRASHED))
        at->until = fmin(at->until, progress_clock() + asked->time_limit);
}

/* False when there is no time. */
static bool ask(aim *at, const sure_case *questions, int count, example *answered)
{
    if (progress_clock() > at->until ||
        !judging_several(at->self, at->best->asks, questions, count, answered))
        return false;
    for (int i = 0; i < count; i++)
        mind_the_time(at, &answered[i]);
    return true;
}

/* One case after the other. */

static bool fails(const sure_case *question, void *context)
{
    aim *at = context;
    example one;
    if (at->tries-- <= 0 || !ask(at, question, 1, &one) || !does_it(at, &one))
        return false;
    at->best->found = one;
    return true;
}

/* Several at a time. */

typedef struct {
    int count;
    sure_case list[JUDGING_SEVERAL];
    example answered[JUDGING_SEVERAL];
} several;

/* Notes what would be tried, and accepts nothing. */
static bool note(const sure_case *question, void *context)
{
    several *all = context;
    if (all->count < JUDGING_SEVERAL)
        all->list[all->count++] = *question;
    return false;
}

/* Of each number the simplest value that does it alone; then those together, one more each time. */
static int join(const aim *at, const several *all, sure_case joined[CASE_NUMBERS_MAX])
{
    sure_case base = at->best->found.question, sum = base;
    int count = 0, last = -1;
    for (int i = 0; i < all->count; i++) {
        sure_case tried = all->list[i];
        int n = 0; /* the number in which it differs */
        while (memcmp(case_number(&base, n), case_number(&tried, n), sizeof(double)) == 0)
            n++;
        if (n == last || !does_it(at, &all->answered[i]))
            continue;
        *case_number(&sum, n) = *case_number(&tried, n);
        joined[count++] = sum;
        last = n;
    }
    return count;
}

/* False when nothing is simpler. */
static bool make_simpler(aim *at, bool coarsely, several *all)
{
    sure_case base = at->best->found.question, joined[CASE_NUMBERS_MAX];
    example answered[CASE_NUMBERS_MAX];
    all->count = 0;
    shrink_case(&base, coarsely, note, all);
    at->tries -= all->count;
    if (all->count == 0 || at->tries < 0 || !ask(at, all->list, all->count, all->answered))
        return false;
    int count = join(at, all, joined);
    if (count == 0 || !ask(at, joined, count, answered))
        return false;
    while (count > 0 && !does_it(at, &answered[count - 1]))
        count--;
    if (count > 0)
        at->best->found = answered[count - 1];
    return count > 0;
}

static void make_simple_by_several(aim *at)
{
    several *all = malloc(sizeof *all);
    at->tries = TRIES_BY_SEVERAL;
    while (all && (make_simpler(at, true, all) || make_simpler(at, false, all)))
        ;
    free(all);
}

static void make_simple_one_by_one(aim *at)
{
    sure_case question = at->best->found.question;
    at->tries = TRIES_ONE_BY_ONE;
    if (!fails(&question, at)) /* once more: some happen only now and then */
        return;
    question = shrink_case(&question, true, fails, at);
    shrink_case(&question, false, fails, at);
}

/* An error at least half as large is the same one. */
static void make_simple(judging *self, worst_case *one)
{
    aim at = {.self = self, .best = one, .until = INFINITY};
    bool ends_it = one->kind >= FAULT_CRASHED && one->kind <= FAULT_LOST;
    if (one->kind == FAULT_HUNG || (ends_it && !judging_is_quick(self)))
        return; /* each try costs too much */
    if (one->kind >= FAULTS)
        at.least = worst_size(one->kind, &one->found, one->in) / 2;
    if (judging_is_quick(self))
        make_simple_one_by_one(&at);
    else
        make_simple_by_several(&at);
}

int worst_find(judging *self, const judging_row *rows, int count, worst_case list[WORST_KINDS])
{
    int found = 0;
    for (int kind = 0; kind < WORST_KINDS; kind++) {
        worst_case *one = &list[found];
        if (!choose(self, rows, count, kind, one))
            continue;
        make_simple(self, one);
        found++;
    }
    return found;
}
