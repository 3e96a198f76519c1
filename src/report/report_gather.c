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

uint64_t report_row_cases(const report_row *row)
{
    return row->sum.cases + row->sum.unasked;
}

static uint64_t cases_of(const report_plan *plan, const report_candidate *who, regime which)
{
    uint64_t cases = report_cases(plan, which);
    return who->truth == REPORT_BY_REFERENCE ? cases * REPORT_REFERENCE_CASES : cases;
}

/* Nothing that exact says of itself or of certain, which shares its code, is evidence. */
static void set_truth(const report_plan *plan, report_candidate *who)
{
    bool knows = !who->library && who->tier >= SURE_TIER_CERTAIN;
    who->truth = !knows         ? REPORT_BY_EXACT
                 : plan->reference ? REPORT_BY_REFERENCE
                                   : REPORT_BY_LIKE;
}

/* In a process that works. */

static bool judge_rows(judging *by, const report_plan *plan, const report_candidate *who,
                       sure_shape shape, report_shape *found, char *message)
{
    judging_row row;
    found->in_float = judging_precision(by, shape) == PRECISION_FLOAT;
    for (int which = 0; which < REGIMES; which++) {
        if (!judging_has(by, (int)shape) || !regime_rows_have(&plan->rows, (int)shape, which))
            continue;
        if (!judging_regime(by, shape, (regime)which, cases_of(plan, who, (regime)which), &row,
                            message))
            return false;
        found->rows[which] = (report_row){.sum = row.sum};
    }
    return true;
}

static void judge_shape(const report_plan *plan, const report_candidate *who, sure_shape shape,
                        report_shape *found)
{
    char message[CANDIDATE_MESSAGE];
    const judging_plan one = {.subject = who->library ? SUBJECT_LIBRARY : SUBJECT_TIER,
                              .name = who->library,
                              .tier = who->tier,
                              .how = {.time_limit = TIME_LIMIT},
                              .by_reference = who->truth == REPORT_BY_REFERENCE,
                              .untimed = true,
                              .seed = plan->seed};
    judging *by = judging_open(&one, message);
    if (!by || !judge_rows(by, plan, who, shape, found, message))
        snprintf(found->trouble, sizeof found->trouble, "%.*s", REPORT_MESSAGE - 1, message);
    judging_close(by);
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

/* Until all have ended. */
static void wait_for(const work *all, int started, progress *bar)
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
        if (bar)
            progress_step(bar, atomic_load(&all->shared->done) - bar->done);
    }
}

const char *report_gather(const report_plan *plan, report_candidate *list, int count, progress *bar)
{
    work all = {.plan = plan, .list = list};
    all.shared =
        mmap(NULL, sizeof *all.shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (all.shared == MAP_FAILED)
        return strerror(errno);
    for (int i = 0; i < count; i++) {
        set_truth(plan, &list[i]);
        list[i].shapes = all.shared->found[i];
    }
    plan_jobs(&all, count);
    int started = start(&all);
    wait_for(&all, started, bar);
    if (atomic_load(&all.shared->done) < all.job_count)
        return started > 0 ? "a process that judges has ended early" : "no process to judge in";
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        report_take_times(plan, list, count, (sure_shape)shape);
        if (bar)
            progress_step(bar, 1);
    }
    return NULL;
}
