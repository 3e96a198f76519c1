/* Times that can be compared: everyone is asked for hits alone, of the same cases, in turns, each
 * in a process of its own that calls and times all of them alike (plugin.h). */
#include "report.h"

#include "../judge/candidates/candidate.h"
#include "../judge/candidates/plugin.h"
#include "../support/median.h"

#include <stdlib.h>
#include <string.h>

#define TIME_LIMIT 5      /* seconds, for the answer to a case */
#define TURN PLUGIN_BLOCK /* cases that one is asked before it is the next one's turn */
#define TYPICAL_TURNS 16  /* of the regime, ... */
#define HARD_TURNS 2      /* ... and of each other one */
#define ROUNDS 5          /* of each turn: their median counts */

typedef struct {
    candidate *asked;      /* NULL: it can't be */
    bool out;              /* of this regime: it has no times there */
    double rounds[ROUNDS]; /* nanoseconds */
    double nanoseconds;    /* of all rays */
    uint64_t rays;
    bool with_normals;
} runner;

typedef struct {
    runner runners[REPORT_CANDIDATES];
    int count;
    sure_shape shape;
    sure_case cases[TURN];
    int case_count;
    block room;
    rng order;
} contest;

/* The cases as it is judged by them. */
static void fill(contest *all, bool in_float)
{
    block *room = &all->room;
    room->shape = all->shape;
    room->count = 0;
    room->for_time = true;
    for (int i = 0; i < all->case_count; i++) {
        sure_case *place = &room->cases[room->count];
        *place = all->cases[i];
        room->count += !in_float || float_case(&all->cases[i], place);
    }
}

static void run(contest *all, runner *one, int round)
{
    fill(all, one->asked->answers_in[all->shape] == PRECISION_FLOAT);
    if (all->room.count == 0) {
        one->out = true;
        return;
    }
    candidate_ask(one->asked, &all->room);
    one->rounds[round] = all->room.nanoseconds;
    one->with_normals |= all->room.with_normals;
    one->out |= all->room.nanoseconds == 0;
    if (round == 0)
        one->rays += (uint64_t)all->room.count;
}

/* Who begins and the order of the cases change from round to round. */
static void take_turn(contest *all)
{
    for (int round = 0; round < ROUNDS; round++) {
        shuffle_cases(all->cases, all->case_count, &all->order);
        for (int i = 0; i < all->count; i++) {
            runner *one = &all->runners[(i + round) % all->count];
            if (!one->out)
                run(all, one, round);
        }
    }
    for (int i = 0; i < all->count; i++) {
        runner *one = &all->runners[i];
        one->nanoseconds += median_of(one->rounds, ROUNDS);
    }
}

static void make_cases(contest *all, const report_plan *plan, regime which, uint64_t first)
{
    uint64_t left = report_cases(plan, which) - first;
    all->case_count = left < TURN ? (int)left : TURN;
    for (int i = 0; i < all->case_count; i++)
        all->cases[i] = regime_case(all->shape, which, plan->seed, first + (uint64_t)i);
}

/* Did it crash, hang or get out of step somewhere? */
static bool is_ended(const report_row *row)
{
    const uint64_t *faults = row->sum.faults;
    return faults[FAULT_CRASHED] + faults[FAULT_HUNG] + faults[FAULT_LOST] > 0;
}

static void take_turns(contest *all, const report_plan *plan, report_candidate *list, regime which)
{
    uint64_t cases = report_cases(plan, which);
    uint64_t turns = which == REGIME_TYPICAL ? TYPICAL_TURNS : HARD_TURNS;
    for (int i = 0; i < all->count; i++) {
        const report_row *row = &list[i].shapes[all->shape].rows[which];
        runner *one = &all->runners[i];
        one->out = !one->asked || report_row_cases(row) == 0 || is_ended(row);
        one->nanoseconds = 0;
        one->rays = 0;
    }
    for (uint64_t turn = 0; turn < turns && turn * TURN < cases; turn++) {
        make_cases(all, plan, which, turn * TURN);
        take_turn(all);
    }
    for (int i = 0; i < all->count; i++) {
        const runner *one = &all->runners[i];
        report_shape *of = &list[i].shapes[all->shape];
        of->with_normals |= one->with_normals;
        if (!one->out)
            of->rows[which].nanoseconds = one->nanoseconds / (double)one->rays;
    }
}

void report_take_times(const report_plan *plan, report_candidate *list, int count, sure_shape shape)
{
    const candidate_options how = {.time_limit = TIME_LIMIT};
    char message[CANDIDATE_MESSAGE];
    contest *all = calloc(1, sizeof *all);
    if (!all)
        return; /* the report then says of times that they are not known */
    all->shape = shape;
    all->count = count;
    for (int i = 0; i < count; i++)
        all->runners[i].asked = list[i].library
                                    ? candidate_of_library(list[i].library, &how, message)
                                    : candidate_of_tier(list[i].tier, false, &how, message);
    for (int which = 0; which < REGIMES; which++) {
        if (regime_rows_have(&plan->rows, (int)shape, which))
            take_turns(all, plan, list, (regime)which);
    }
    for (int i = 0; i < count; i++)
        candidate_close(all->runners[i].asked);
    free(all);
}
