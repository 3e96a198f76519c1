/* Some processes share the work: each takes the number of a job from a pipe and writes what it
 * finds into another, whole at a time. First a job is to judge a candidate in a shape; when all are
 * done, it is to take everyone's times in a shape, and one process has the machine to itself. */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE /* prctl */

#include "report_gathered.h"

#include "../candidates/child.h"
#include "../judging.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define TIME_LIMIT 5 /* seconds, for the answer to a case */
#define TYPICAL 20   /* times as many of these cases */
#define DEAR 4       /* and so many times fewer, where the exact stage takes milliseconds */

/* Jobs by number: of a candidate and a shape, then of a shape. */
_Static_assert(REPORT_CANDIDATES *SURE_SHAPES <= 256, "the number of a job is a byte");

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

/* Nothing that exact says of itself or of certain, which shares its code, is evidence: where it
 * must be shown all the same, it is marked wherever their names are. */
static void set_truth(const report_plan *plan, report_candidate *who)
{
    bool promises = !who->library && who->tier >= SURE_TIER_CERTAIN;
    who->truth = !promises         ? REPORT_BY_EXACT
                 : plan->reference ? REPORT_BY_REFERENCE
                                   : REPORT_BY_LIKE;
    if (who->truth == REPORT_BY_LIKE)
        who->name = who->tier == SURE_TIER_EXACT ? "exact*" : "certain*";
}

/* In a process that works. */

void report_put(int results, const finding *one)
{
    if (write(results, one, sizeof *one) != (ssize_t)sizeof *one)
        _exit(EXIT_FAILURE);
}

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
                       finding *one, int results, char *message)
{
    judging_row row;
    for (int which = 0; which < REGIMES; which++) {
        if (!plan->wanted[one->shape][which])
            continue;
        one->which = which;
        if (!judging_regime(by, (sure_shape)one->shape, (regime)which, plan->seed,
                            cases_of(plan, who, (regime)which), &row, message))
            return false;
        one->is.row = row_of(&row);
        report_put(results, one);
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

static bool judge_shape(const report_plan *plan, const report_candidate *who, finding *one,
                        int results, char *message)
{
    judging_parties parties;
    bool done = open_parties(who, &parties, message);
    if (done && parties.asked->answers[one->shape]) {
        judging *by = judging_new(&parties);
        one->in_float = parties.asked->answers_in[one->shape] == PRECISION_FLOAT;
        done = by && judge_rows(by, plan, who, one, results, message);
        judging_free(by);
    }
    candidate_close(parties.asked);
    truth_close(&parties.known);
    return done;
}

/* What is shared out. */
typedef struct {
    const report_plan *plan;
    report_candidate *list;
    int count;
    bool times; /* not to be judged any more, but to be timed */
    unsigned char jobs[REPORT_CANDIDATES * SURE_SHAPES];
    int job_count;
} work;

static void add_jobs(work *all, int who)
{
    for (int shape = SURE_SHAPES - 1; shape >= 0; shape--)
        all->jobs[all->job_count++] = (unsigned char)(who * SURE_SHAPES + shape);
}

/* What takes longest comes first: who is held against the reference, and the later shapes. */
static void plan_jobs(work *all)
{
    all->job_count = 0;
    if (all->times)
        add_jobs(all, 0);
    for (int slow = 1; !all->times && slow >= 0; slow--) {
        for (int i = 0; i < all->count; i++) {
            if ((all->list[i].truth == REPORT_BY_REFERENCE) == (slow == 1))
                add_jobs(all, i);
        }
    }
}

static void do_job(const work *all, int job, int results)
{
    char message[CANDIDATE_MESSAGE] = "no memory";
    finding one = {.kind = FOUND_ROW, .candidate = job / SURE_SHAPES, .shape = job % SURE_SHAPES};
    bool done = true;
    if (all->times)
        report_take_times(all->plan, all->list, all->count, (sure_shape)one.shape, results);
    else
        done = judge_shape(all->plan, &all->list[one.candidate], &one, results, message);
    one.kind = FOUND_END;
    memset(&one.is, 0, sizeof one.is);
    if (!done)
        memcpy(one.is.trouble, message, sizeof one.is.trouble - 1);
    report_put(results, &one);
}

static _Noreturn void live_as_worker(const work *all, int jobs, int results)
{
    unsigned char job;
    child_begins();
    while (read(jobs, &job, 1) == 1)
        do_job(all, job, results);
    _exit(EXIT_SUCCESS);
}

/* In the process that waits. */

static bool get(int results, finding *one)
{
    size_t have = 0;
    while (have < sizeof *one) {
        ssize_t more = read(results, (char *)one + have, sizeof *one - have);
        if (more < 0 && errno == EINTR)
            continue;
        if (more <= 0)
            return false;
        have += (size_t)more;
    }
    return true;
}

static void take(report_candidate *who, const finding *one)
{
    switch (one->kind) {
    case FOUND_ROW:
        who->in_float |= one->in_float;
        who->rows[one->shape][one->which] = one->is.row;
        return;
    case FOUND_TIME:
        who->with_normals |= one->with_normals;
        who->rows[one->shape][one->which].nanoseconds = one->is.nanoseconds;
        return;
    case FOUND_END: break;
    }
    if (one->is.trouble[0] != '\0')
        memcpy(who->trouble, one->is.trouble, sizeof who->trouble);
}

/* How much is done, and who is told. */
typedef struct {
    int done, of;
    report_step *step;
    void *context;
} advance;

/* How many jobs were done. */
static int collect(int results, work *all, advance *so_far)
{
    finding one;
    int done = 0;
    while (get(results, &one)) {
        take(&all->list[one.candidate], &one);
        if (one.kind != FOUND_END)
            continue;
        done++;
        so_far->done++;
        if (so_far->step)
            so_far->step(so_far->context, so_far->done, so_far->of);
    }
    return done;
}

static int start(const work *all, int jobs, int results)
{
    int started = 0, wanted = all->times ? 1 : all->plan->processes;
    fflush(NULL); /* nothing that is buffered may be written twice */
    while (started < wanted) {
        pid_t child = fork();
        if (child == 0)
            live_as_worker(all, jobs, results);
        if (child < 0)
            break;
        started++;
    }
    return started;
}

static bool fail(char *message, const char *why)
{
    snprintf(message, REPORT_MESSAGE, "%s", why);
    return false;
}

/* A pipe and nothing left open. */
static bool open_pipes(int jobs[2], int results[2])
{
    if (pipe(jobs) != 0)
        return false;
    if (pipe(results) == 0)
        return true;
    close(jobs[0]);
    close(jobs[1]);
    return false;
}

static bool share_out(work *all, advance *so_far, char message[REPORT_MESSAGE])
{
    int jobs[2], results[2];
    plan_jobs(all);
    if (!open_pipes(jobs, results))
        return fail(message, strerror(errno));
    bool put = write(jobs[1], all->jobs, (size_t)all->job_count) == all->job_count;
    close(jobs[1]);
    int started = put ? start(all, jobs[0], results[1]) : 0;
    close(jobs[0]);
    close(results[1]);
    int done = started > 0 ? collect(results[0], all, so_far) : 0;
    close(results[0]);
    for (int i = 0; i < started; i++) {
        while (wait(NULL) < 0 && errno == EINTR)
            ;
    }
    return done == all->job_count ||
           fail(message,
                started > 0 ? "a process that judges has ended early" : "no process to judge in");
}

bool report_gather(const report_plan *plan, report_candidate *list, int count, report_step *step,
                   void *context, char message[REPORT_MESSAGE])
{
    work all = {.plan = plan, .list = list, .count = count};
    advance so_far = {0, REPORT_STEPS(count), step, context};
    for (int i = 0; i < count; i++)
        set_truth(plan, &list[i]);
    if (!share_out(&all, &so_far, message))
        return false;
    all.times = true;
    return share_out(&all, &so_far, message);
}
