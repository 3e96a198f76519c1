/* Some processes share the work: each takes the next job, which is to judge a candidate in a shape,
 * and writes what it finds into memory that all of them share. When all are done, everyone's times
 * are taken, with nothing else at work. */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE /* prctl, MAP_ANONYMOUS */

#include "report.h"

#include "../judge/candidates/child.h"
#include "../judge/judging.h"

#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define TIME_LIMIT 5 /* seconds, for the answer to a case */
#define TYPICAL 20   /* times as many of these cases */
#define DEAR 4       /* and so many times fewer, where the exact stage takes milliseconds */

uint64_t report_cases(const report_plan *plan, regime which)
{
    if (which == REGIME_TYPICAL)
        return plan->count * TYPICAL;
    if (which == REGIME_BITS || which == REGIME_DEGENERATE)
        return (plan->count + DEAR - 1) / DEAR;
    return plan->count;
}

static uint64_t cases_of(const report_plan *plan, const report_candidate *who, regime which)
{
    uint64_t cases = report_cases(plan, which);
    return who->truth == REPORT_BY_REFERENCE ? cases * REPORT_REFERENCE_CASES : cases;
}

/* Nothing that exact says of itself or of certain, which shares its code, is evidence. */
static void set_truth(const report_plan *plan, report_candidate *who)
{
    bool promises = !who->library && who->tier >= SURE_TIER_CERTAIN;
    who->truth = !promises         ? REPORT_BY_EXACT
                 : plan->reference ? REPORT_BY_REFERENCE
                                   : REPORT_BY_LIKE;
}

/* In a process that works. */

static report_row row_of(const judging_row *from)
{
    const verdict *sum = &from->sum;
    report_row row = {.t_median = sum->t_ulps.median,
                      .t_q99 = sum->t_ulps.q99,
                      .t_most = sum->t_ulps.most,
                      .cases = (uint32_t)(sum->cases + sum->unasked),
                      .valid = (uint32_t)sum->valid,
                      .wrong = (uint32_t)sum->wrong,
                      .breaches = (uint32_t)verdict_breaches(sum),
                      .unasked = (uint32_t)sum->unasked,
                      .t_right = (uint32_t)sum->t_ulps.right,
                      .t_count = (uint32_t)sum->t_ulps.count};
    for (int i = 0; i < SIZE_CLASSES; i++)
        row.t_classes[i] = (uint32_t)sum->t_classes[i];
    for (int i = FAULT_CRASHED; i <= FAULT_LOST; i++)
        row.ended |= sum->faults[i] > 0;
    return row;
}

static bool judge_rows(judging *by, const report_plan *plan, const report_candidate *who,
                       sure_shape shape, report_shape *found)
{
    char message[CANDIDATE_MESSAGE];
    judging_row row;
    for (int which = 0; which < REGIMES; which++) {
        if (!regime_rows_have(&plan->rows, (int)shape, which))
            continue;
        if (!judging_regime(by, shape, (regime)which, plan->seed,
                            cases_of(plan, who, (regime)which), &row, message)) {
            snprintf(found->trouble, sizeof found->trouble, "%.*s", REPORT_MESSAGE - 1, message);
            return false;
        }
        found->rows[which] = row_of(&row);
    }
    return true;
}

static bool open_parties(const report_candidate *who, judging_parties *parties, char *message)
{
    const candidate_options how = {.time_limit = TIME_LIMIT};
    *parties = (judging_parties){.known = truth_exact(), .untimed = true};
    parties->asked = who->library ? candidate_of_library(who->library, &how, message)
                                  : candidate_of_tier(who->tier, &how, message);
    return parties->asked &&
           (who->truth != REPORT_BY_REFERENCE || truth_reference(&how, &parties->known, message));
}

static void judge_shape(const report_plan *plan, const report_candidate *who, sure_shape shape,
                        report_shape *found)
{
    char message[CANDIDATE_MESSAGE] = "no memory";
    judging_parties parties;
    if (!open_parties(who, &parties, message)) {
        snprintf(found->trouble, sizeof found->trouble, "%.*s", REPORT_MESSAGE - 1, message);
    } else if (parties.asked->answers[shape]) {
        judging *by = judging_new(&parties);
        found->in_float = parties.asked->answers_in[shape] == PRECISION_FLOAT;
        if (by)
            (void)judge_rows(by, plan, who, shape, found);
        else
            snprintf(found->trouble, sizeof found->trouble, "no memory");
        judging_free(by);
    }
    candidate_close(parties.asked);
    truth_close(&parties.known);
}

/* What is shared. */
typedef struct {
    atomic_int next, done; /* jobs */
    report_shape found[REPORT_CANDIDATES][SURE_SHAPES];
} board;

/* The jobs in their order: what takes longest comes first, that is who is held against the
 * reference, and the later shapes. */
typedef struct {
    const report_plan *plan;
    const report_candidate *list;
    board *shared;
    int job_count;
    struct {
        int who, shape;
    } jobs[REPORT_CANDIDATES * SURE_SHAPES];
} work;

static void plan_jobs(work *all, int count)
{
    for (int slow = 1; slow >= 0; slow--) {
        for (int i = 0; i < count * SURE_SHAPES; i++) {
            int who = i / SURE_SHAPES, shape = SURE_SHAPES - 1 - i % SURE_SHAPES;
            if ((all->list[who].truth == REPORT_BY_REFERENCE) != (slow == 1))
                continue;
            all->jobs[all->job_count].who = who;
            all->jobs[all->job_count++].shape = shape;
        }
    }
}

static _Noreturn void live_as_worker(const work *all)
{
    child_begins();
    for (int job; (job = atomic_fetch_add(&all->shared->next, 1)) < all->job_count;) {
        int who = all->jobs[job].who, shape = all->jobs[job].shape;
        judge_shape(all->plan, &all->list[who], (sure_shape)shape, &all->shared->found[who][shape]);
        atomic_fetch_add(&all->shared->done, 1);
    }
    _exit(EXIT_SUCCESS);
}

/* In the process that waits. */

static int start(const work *all)
{
    int started = 0;
    fflush(NULL); /* nothing that is buffered may be written twice */
    while (started < all->plan->processes) {
        pid_t id = fork();
        if (id == 0)
            live_as_worker(all);
        if (id < 0)
            break;
        started++;
    }
    return started;
}

/* Until all have ended; tells how much is done. */
static void wait_for(const work *all, int started, report_step *step, void *context, int of)
{
    const struct timespec moment = {0, 50000000};
    while (started > 0) {
        pid_t ended = waitpid(-1, NULL, WNOHANG);
        if (ended > 0)
            started--;
        else if (ended == 0)
            nanosleep(&moment, NULL);
        else if (errno != EINTR)
            return;
        if (step)
            step(context, atomic_load(&all->shared->done), of);
    }
}

static bool fail(char *message, const char *why)
{
    snprintf(message, REPORT_MESSAGE, "%s", why);
    return false;
}

static bool judge_all(work *all, int count, report_step *step, void *context, char *message)
{
    plan_jobs(all, count);
    int started = start(all);
    wait_for(all, started, step, context, REPORT_STEPS(count));
    return atomic_load(&all->shared->done) == all->job_count ||
           fail(message,
                started > 0 ? "a process that judges has ended early" : "no process to judge in");
}

bool report_gather(const report_plan *plan, report_candidate *list, int count, report_step *step,
                   void *context, char message[REPORT_MESSAGE])
{
    work all = {.plan = plan, .list = list};
    for (int i = 0; i < count; i++)
        set_truth(plan, &list[i]);
    all.shared =
        mmap(NULL, sizeof *all.shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (all.shared == MAP_FAILED)
        return fail(message, strerror(errno));
    bool done = judge_all(&all, count, step, context, message);
    for (int i = 0; i < count; i++)
        memcpy(list[i].shapes, all.shared->found[i], sizeof list[i].shapes);
    munmap(all.shared, sizeof *all.shared);
    for (int shape = 0; done && shape < SURE_SHAPES; shape++) {
        report_take_times(plan, list, count, (sure_shape)shape);
        if (step)
            step(context, all.job_count + shape + 1, REPORT_STEPS(count));
    }
    return done;
}
