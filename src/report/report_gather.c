/* SPDX-License-Identifier: MIT */
/* Some processes share the work: each does a job, which is to judge a candidate in a shape, and
 * writes what it finds into memory that all of them share. When all are done, everyone's times are
 * taken, with nothing else at work. */
#include "report.h"

#include "../judge/bench/instructions.h"
#include "../judge/candidates/child.h"
#include "../judge/candidates/plugin.h"
#include "../support/median.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#define CAMERA 5     /* times as many of these cases */
#define DEAR 4       /* and so many times fewer, where the exact stage takes milliseconds */

uint64_t report_cases(const report_plan *plan, regime which)
{
    if (which == REGIME_CAMERA)
        return plan->count * CAMERA;
    if (which == REGIME_BITS || which == REGIME_DEGENERATE)
        return (plan->count + DEAR - 1) / DEAR;
    return plan->count;
}

uint64_t report_row_cases(const judging_row *row)
{
    return row->sum.cases + row->sum.unasked;
}

/* Nothing that exact says of itself or of certain, which shares its code, is evidence. */
static void set_truth(const report_plan *plan, report_candidate *who)
{
    bool knows = !who->library && who->tier >= SURE_TIER_CERTAIN;
    who->truth = !knows ? REPORT_BY_EXACT : plan->reference ? REPORT_BY_REFERENCE : REPORT_BY_LIKE;
}

/* In a process that works. */

static bool judge_rows(judging *by, const report_plan *plan, const report_candidate *who,
                       sure_shape shape, report_shape *found)
{
    bool has = judging_asked(by)->answers[QUERY_HIT][shape];
    found->in_float = has && judging_asked(by)->answers_in[QUERY_HIT][shape] == PRECISION_FLOAT;
    for (int which = 0; which < REGIMES; which++) {
        if (!has || !regime_rows_have(&plan->rows, (int)shape, which))
            continue;
        uint64_t times = who->truth == REPORT_BY_REFERENCE ? REPORT_REFERENCE_CASES : 1;
        if (!judging_regime(by, QUERY_HIT, shape, (regime)which,
                            times * report_cases(plan, (regime)which), &found->rows[which],
                            found->trouble))
            return false;
    }
    found->who = judging_who(by);
    found->worst_count = worst_find(by, found->rows, REGIMES, found->worst);
    return true;
}

static void judge_shape(const report_plan *plan, const report_candidate *who, sure_shape shape)
{
    report_shape *found = &who->shapes[shape];
    const judging_plan one = {.subject = who->library ? SUBJECT_LIBRARY : SUBJECT_TIER,
                              .name = who->library,
                              .tier = who->tier,
                              .how = {INPUTS_AS_IT_TAKES, .time_limit = CANDIDATE_TIME_LIMIT},
                              .by_reference = who->truth == REPORT_BY_REFERENCE,
                              .untimed = true,
                              .told = margins_of(MARGIN_SIZE),
                              .seed = plan->seed};
    judging *by = judging_open(&one, found->trouble);
    if (by && judge_rows(by, plan, who, shape, found))
        found->trouble[0] = '\0';
    judging_close(by);
}

typedef struct {
    int who, shape;
} job;

/* What takes longest comes first, that is who is held against the reference, and the later shapes.
 */
static int plan_jobs(const report_candidate *list, int count, job *jobs)
{
    int planned = 0;
    for (int slow = 1; slow >= 0; slow--) {
        for (int i = 0; i < count * SURE_SHAPES; i++) {
            job one = {i / SURE_SHAPES, SURE_SHAPES - 1 - i % SURE_SHAPES};
            if ((list[one.who].truth == REPORT_BY_REFERENCE) == (slow == 1))
                jobs[planned++] = one;
        }
    }
    return planned;
}

/* Jobs whose processes run; others may be this one's children, too. */
typedef struct {
    pid_t ids[REPORT_PROCESSES];
    int count;
} running_jobs;

/* Waits for one of them; whether it ended well. */
static bool wait_for_one(running_jobs *of)
{
    for (;;) {
        int ended = 0, i = 0;
        pid_t id = wait(&ended);
        if (id < 0 && errno == EINTR)
            continue;
        while (i < of->count && of->ids[i] != id)
            i++;
        if (id > 0 && i == of->count)
            continue;
        of->count--;
        if (id > 0)
            of->ids[i] = of->ids[of->count];
        return id > 0 && ended == EXIT_SUCCESS;
    }
}

/* Each in a process of its own. NULL, or what is wrong. */
static const char *do_jobs(const report_plan *plan, const report_candidate *list, const job *jobs,
                           int count, progress *bar)
{
    const char *wrong = NULL;
    running_jobs now = {.count = 0};
    fflush(NULL); /* nothing that is buffered may be written twice */
    for (int started = 0; started < count || now.count > 0;) {
        pid_t id = started < count && now.count < plan->processes ? fork() : -1;
        if (id == 0) {
            child_begins();
            judge_shape(plan, &list[jobs[started].who], (sure_shape)jobs[started].shape);
            _exit(EXIT_SUCCESS);
        }
        if (id > 0) {
            started++;
            now.ids[now.count++] = id;
            continue;
        }
        if (now.count == 0)
            return "no process to judge in";
        if (!wait_for_one(&now))
            wrong = "a process that judges has ended early";
        progress_step(bar, 1);
    }
    return wrong;
}

/* Times that can be compared: everyone is asked for hits alone, of the same cases, in turns, each
 * in a process of its own that calls and times all of them alike (plugin.h). */

#define TURN PLUGIN_BLOCK /* cases that one is asked before it is the next one's turn */
#define CAMERA_TURNS 8    /* of the regime, ... */
#define HARD_TURNS 1      /* ... and of each other one */
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
    fill(all, one->asked->answers_in[QUERY_HIT][all->shape] == PRECISION_FLOAT);
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
static bool is_ended(const judging_row *row)
{
    const uint64_t *faults = row->sum.faults;
    return faults[FAULT_CRASHED] + faults[FAULT_HUNG] + faults[FAULT_LOST] > 0;
}

static void take_turns(contest *all, const report_plan *plan, report_candidate *list, regime which)
{
    uint64_t cases = report_cases(plan, which);
    uint64_t turns = instructions_counting()  ? 1
                     : which == REGIME_CAMERA ? CAMERA_TURNS
                                              : HARD_TURNS;
    for (int i = 0; i < all->count; i++) {
        const judging_row *row = &list[i].shapes[all->shape].rows[which];
        runner *one = &all->runners[i];
        one->out = !one->asked ||
                   (!instructions_counting() && (report_row_cases(row) == 0 || is_ended(row)));
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
        double each = one->out ? 0 : one->nanoseconds / (double)one->rays;
        of->rows[which].times.candidate = each;
        if (which == REGIME_CAMERA)
            of->rows[which].instructions.candidate = instructions_figure(each);
    }
}

static void take_all_times(const report_plan *plan, report_candidate *list, int count,
                           sure_shape shape)
{
    const candidate_options how = {INPUTS_AS_IT_TAKES, .time_limit = CANDIDATE_TIME_LIMIT};
    contest *all = calloc(1, sizeof *all);
    if (!all)
        return; /* the report then says of times that they are not known */
    all->shape = shape;
    all->count = count;
    for (int i = 0; i < count; i++)
        all->runners[i].asked = list[i].library
                                    ? candidate_of_library(list[i].library, &how, NULL)
                                    : candidate_of_tier(list[i].tier, false, &how, NULL);
    for (int which = 0; which < REGIMES; which++) {
        if (regime_rows_have(&plan->rows, (int)shape, which) &&
            (which == REGIME_CAMERA || !instructions_counting()))
            take_turns(all, plan, list, (regime)which);
    }
    for (int i = 0; i < count; i++)
        candidate_close(all->runners[i].asked);
    free(all);
}

const char *report_gather(const report_plan *plan, report_candidate *list, int count, progress *bar)
{
    static job jobs[REPORT_CANDIDATES * SURE_SHAPES];
    size_t size = (size_t)count * SURE_SHAPES * sizeof(report_shape);
    report_shape *found =
        mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (found == MAP_FAILED)
        return strerror(errno);
    for (int i = 0; i < count; i++) {
        set_truth(plan, &list[i]);
        list[i].shapes = found + (size_t)i * SURE_SHAPES;
    }
    const char *wrong = instructions_counting()
                            ? NULL
                            : do_jobs(plan, list, jobs, plan_jobs(list, count, jobs), bar);
    for (int shape = 0; shape < SURE_SHAPES && !wrong; shape++) {
        take_all_times(plan, list, count, (sure_shape)shape);
        progress_step(bar, 1);
    }
    return wrong;
}
