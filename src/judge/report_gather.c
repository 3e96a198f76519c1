/* Some processes share the work: each takes the number of a job (a candidate and a stem) from a
 * pipe, and writes the rows into another, whole at a time. */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE /* prctl */

#include "report.h"

#include "child.h"
#include "judging.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define TIME_LIMIT 5 /* seconds, for the answer to a case */
#define ROUNDS 3     /* typical is asked so often, for the median of its times */
#define TYPICAL 20   /* times as many of these cases */
#define DEAR 4       /* and so many times fewer, where the exact stage takes milliseconds */

#define NO_ROW (-1)

/* What a pipe takes whole, whoever else writes. */
#define PIPE_WHOLE 512
typedef struct {
    int candidate, shape, which; /* NO_ROW: the job is done, or `trouble` says why it is not */
    bool in_float;
    union {
        report_row row;
        char trouble[REPORT_MESSAGE];
    } is;
} finding;
_Static_assert(sizeof(finding) <= PIPE_WHOLE, "written whole");
_Static_assert(REPORT_CANDIDATES *SURE_SHAPES <= 256, "the number of a job is a byte");

uint64_t report_cases(const report_plan *plan, regime which)
{
    if (which == REGIME_TYPICAL)
        return plan->count * TYPICAL;
    if (which == REGIME_BITS || which == REGIME_DEGENERATE)
        return (plan->count + DEAR - 1) / DEAR;
    return plan->count;
}

/* In a process that works. */

static void put(int results, const finding *one)
{
    if (write(results, one, sizeof *one) != (ssize_t)sizeof *one)
        _exit(EXIT_FAILURE);
}

static report_row row_of(const judging_row *from)
{
    const verdict *sum = &from->sum;
    report_row row = {.nanoseconds = from->times.candidate,
                      .t_median = sum->t_ulps.median,
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
    return row;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool judge_row(judging *by, const report_plan *plan, finding *one, char *message)
{
    double times[ROUNDS];
    int rounds = one->which == REGIME_TYPICAL ? ROUNDS : 1;
    judging_row row;
    for (int i = 0; i < rounds; i++) {
        regime which = (regime)one->which;
        if (!judging_regime(by, (sure_shape)one->shape, which, plan->seed,
                            report_cases(plan, which), &row, message))
            return false;
        times[i] = row.times.candidate;
    }
    qsort(times, (size_t)rounds, sizeof *times, by_size);
    one->is.row = row_of(&row);
    one->is.row.nanoseconds = times[rounds / 2];
    return true;
}

static bool judge_rows(judging *by, const report_plan *plan, finding *one, int results,
                       char *message)
{
    for (int which = 0; which < REGIMES; which++) {
        if (!plan->wanted[one->shape][which])
            continue;
        one->which = which;
        if (!judge_row(by, plan, one, message))
            return false;
        put(results, one);
    }
    return true;
}

static bool judge_stem(const report_plan *plan, const report_candidate *who, finding *one,
                       int results, char *message)
{
    const candidate_options how = {INPUTS_AS_IT_TAKES, TIME_LIMIT};
    judging_parties parties = {.known = truth_exact()};
    parties.asked = who->library ? candidate_of_library(who->library, &how, message)
                                 : candidate_of_tier(who->tier, &how, message);
    if (!parties.asked)
        return false;
    bool done = true;
    if (parties.asked->answers[one->shape]) {
        judging *by = judging_new(&parties);
        one->in_float = parties.asked->answers_in[one->shape] == PRECISION_FLOAT;
        done = by && judge_rows(by, plan, one, results, message);
        judging_free(by);
    }
    candidate_close(parties.asked);
    return done;
}

/* The stems that take longest come first. */
static finding job_of(int job, int count)
{
    return (finding){.candidate = job % count, .shape = SURE_SHAPES - 1 - job / count};
}

static _Noreturn void work(const report_plan *plan, const report_candidate *list, int count,
                           int jobs, int results)
{
    unsigned char job;
    child_begins();
    while (read(jobs, &job, 1) == 1) {
        char message[CANDIDATE_MESSAGE] = "no memory";
        finding one = job_of(job, count);
        bool done = judge_stem(plan, &list[one.candidate], &one, results, message);
        one.which = NO_ROW;
        memset(&one.is, 0, sizeof one.is);
        if (!done)
            memcpy(one.is.trouble, message, sizeof one.is.trouble - 1);
        put(results, &one);
    }
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

static void take(report_candidate *list, const finding *one)
{
    report_candidate *who = &list[one->candidate];
    if (one->which == NO_ROW) {
        if (one->is.trouble[0] != '\0')
            memcpy(who->trouble, one->is.trouble, sizeof who->trouble);
        return;
    }
    who->in_float |= one->in_float;
    who->rows[one->shape][one->which] = one->is.row;
}

/* How many jobs were done. */
static int collect(int results, report_candidate *list, int jobs, report_step *step, void *context)
{
    finding one;
    int done = 0;
    while (get(results, &one)) {
        take(list, &one);
        if (one.which != NO_ROW)
            continue;
        done++;
        if (step)
            step(context, done, jobs);
    }
    return done;
}

static bool put_jobs(int to, int jobs)
{
    for (int i = 0; i < jobs; i++) {
        unsigned char job = (unsigned char)i;
        if (write(to, &job, 1) != 1)
            return false;
    }
    return true;
}

static int start(const report_plan *plan, const report_candidate *list, int count, int jobs,
                 int results)
{
    int started = 0;
    fflush(NULL); /* nothing that is buffered may be written twice */
    while (started < plan->processes) {
        pid_t child = fork();
        if (child == 0)
            work(plan, list, count, jobs, results);
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

bool report_gather(const report_plan *plan, report_candidate *list, int count, report_step *step,
                   void *context, char message[REPORT_MESSAGE])
{
    int jobs[2], results[2], all = count * SURE_SHAPES;
    if (!open_pipes(jobs, results))
        return fail(message, strerror(errno));
    bool put_all = put_jobs(jobs[1], all);
    close(jobs[1]);
    int started = put_all ? start(plan, list, count, jobs[0], results[1]) : 0;
    close(jobs[0]);
    close(results[1]);
    int done = started > 0 ? collect(results[0], list, all, step, context) : 0;
    close(results[0]);
    for (int i = 0; i < started; i++) {
        while (wait(NULL) < 0 && errno == EINTR)
            ;
    }
    return done == all || fail(message, started > 0 ? "a process that judges has ended early"
                                                    : "no process to judge in");
}
