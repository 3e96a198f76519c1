/* Some processes share the work: each does a job, which is to judge a candidate in a shape, and
 * writes what it finds into memory that all of them share. When all are done, everyone's times are
 * taken, with nothing else at work. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */

#include "report.h"

#include "../judge/candidates/child.h"
#include "../judge/judging.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
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
    who->truth = !knows ? REPORT_BY_EXACT : plan->reference ? REPORT_BY_REFERENCE : REPORT_BY_LIKE;
}

/* In a process that works. */

static bool judge_rows(judging *by, const report_plan *plan, const report_candidate *who,
                       sure_shape shape, report_shape *found, char *message)
{
    judging_row row;
    bool has = judging_asked(by)->answers[shape];
    found->in_float = has && judging_asked(by)->answers_in[shape] == PRECISION_FLOAT;
    for (int which = 0; which < REGIMES; which++) {
        if (!has || !regime_rows_have(&plan->rows, (int)shape, which))
            continue;
        if (!judging_regime(by, shape, (regime)which, cases_of(plan, who, (regime)which), &row,
                            message))
            return false;
        found->rows[which] = (report_row){.sum = row.sum};
    }
    return true;
}

static void judge_shape(const report_plan *plan, const report_candidate *who, sure_shape shape)
{
    report_shape *found = &who->shapes[shape];
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

/* Each in a process of its own. NULL, or what is wrong. */
static const char *do_jobs(const report_plan *plan, const report_candidate *list, const job *jobs,
                           int count, progress *bar)
{
    const char *wrong = NULL;
    fflush(NULL); /* nothing that is buffered may be written twice */
    for (int started = 0, running = 0; started < count || running > 0;) {
        pid_t id = started < count && running < plan->processes ? fork() : -1;
        if (id == 0) {
            child_begins();
            judge_shape(plan, &list[jobs[started].who], (sure_shape)jobs[started].shape);
            _exit(EXIT_SUCCESS);
        }
        if (id > 0) {
            started++;
            running++;
            continue;
        }
        if (running == 0)
            return "no process to judge in";
        int ended = 0;
        if (wait(&ended) < 0)
            continue; /* a signal */
        running--;
        if (ended != EXIT_SUCCESS)
            wrong = "a process that judges has ended early";
        progress_step(bar, 1);
    }
    return wrong;
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
    const char *wrong = do_jobs(plan, list, jobs, plan_jobs(list, count, jobs), bar);
    for (int shape = 0; shape < SURE_SHAPES && !wrong; shape++) {
        report_take_times(plan, list, count, (sure_shape)shape);
        progress_step(bar, 1);
    }
    return wrong;
}
