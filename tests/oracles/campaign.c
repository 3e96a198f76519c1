/* The campaign: the tiers certain and exact against the reference, case by case, over every regime
 * of every shape, with all other tiers counted beside them.
 *
 *     campaign [--cases N] [--seed S] [--processes P] [--record FILE] [--shape NAME]
 *              [--regime NAME]
 *
 * N cases of each pair of shape and regime, a sixth where the answers are longest. With --record
 * the counts are kept in FILE: an interrupted campaign goes on from it, a finished one grows by a
 * greater N. Any broken promise is printed with its case; at a hundred it ends. */
#define _DEFAULT_SOURCE

#include "../support/test_shape.h"
#include "campaign_check.h"

#include <errno.h>
#include <inttypes.h>
#include <popt.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { ROUND = 50000, CHUNK = 50, PROCESSES_MAX = 64, REPORTS = 100, SECONDS_A_ROUND = 600 };

/* What the processes share. */
static struct {
    _Atomic uint64_t next;    /* case to be taken */
    _Atomic uint64_t reports; /* of broken promises */
    struct {
        _Atomic uint64_t index;
        pair_tally sum;
    } process[PROCESSES_MAX];
} * shared;

typedef struct {
    uint64_t cases, seed;
    int processes, shape, regime; /* the last two -1 for all */
    const char *record;
} options;

static volatile sig_atomic_t interrupted;

static void interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

/* A sixth where nearly each answer takes numbers of thousands of digits. */
static uint64_t quota(const options *wanted, sure_shape shape, regime which)
{
    bool longest =
        test_shape_of(shape)->long_numbers && (which == REGIME_BITS || which == REGIME_DEGENERATE);
    return longest ? wanted->cases / 6 : wanted->cases;
}

/* The finalizer of SplitMix64 (Steele, Lea, Flood 2014): what is checked of a case must not go
 * with what a regime makes of its index. */
static uint64_t draw_of(uint64_t index)
{
    uint64_t x = index + UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

/* A quarter of the hits' normals, a sixteenth each of the intervals, of occluded, of the hits'
 * spawns and of the solids' parts, and few of the hits' brackets, which take long. */
static campaign_more more_of(uint64_t index)
{
    uint64_t draw = draw_of(index);
    return (campaign_more){.normal = draw % 4 == 0,
                           .interval = draw / 4 % 16 == 0,
                           .occluded = draw / 64 % 16 == 0,
                           .spawn = draw / 1024 % 16 == 0,
                           .bracket = draw / 262144 % 512 == 0,
                           .parts = draw / 16384 % 16 == 0 ? draw_of(draw) | 1 : 0};
}

static void answer_line(const sure_case *question, sure_tier tier, char *text, size_t size)
{
    sure_hit hit = {0};
    sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (status == SURE_HIT)
        snprintf(text, size, "%s %a %s +- %a", sure_status_name(status), hit.t,
                 sure_part_name(hit.part), hit.t_error);
    else
        snprintf(text, size, "%s", sure_status_name(status));
}

/* In one write, so that the processes' lines don't mix. */
static void report(const sure_case *question, const char *what)
{
    char line[CASE_LINE_MAX], certain[128], exact[128], text[2 * CASE_LINE_MAX];
    if (atomic_fetch_add(&shared->reports, 1) >= REPORTS)
        return;
    case_print(question, line);
    answer_line(question, SURE_TIER_CERTAIN, certain, sizeof certain);
    answer_line(question, SURE_TIER_EXACT, exact, sizeof exact);
    int length = snprintf(text, sizeof text, "%s\n  %s\n  certain %s\n  exact   %s\n", line, what,
                          certain, exact);
    if (write(STDOUT_FILENO, text, (size_t)length) != length)
        abort();
}

static void work(int process, sure_shape shape, regime which, uint64_t seed, uint64_t end)
{
    pair_tally sum = {0};
    uint64_t begin;
    while ((begin = atomic_fetch_add(&shared->next, CHUNK)) < end) {
        for (uint64_t i = begin; i < end && i < begin + CHUNK; i++) {
            atomic_store(&shared->process[process].index, i);
            sure_case question = regime_case(shape, which, seed, i);
            campaign_check(&question, more_of(i), report, &sum);
        }
        if (atomic_load(&shared->reports) >= REPORTS)
            break;
    }
    shared->process[process].sum = sum;
}

/* A process that did not come to its end: a crash, or no answer in time. */
static void report_lost(int process, sure_shape shape, regime which, uint64_t seed)
{
    char line[CASE_LINE_MAX];
    uint64_t index = atomic_load(&shared->process[process].index);
    sure_case question = regime_case(shape, which, seed, index);
    case_print(&question, line);
    printf("%s\n  no answer: %s %s, seed %" PRIu64 ", case %" PRIu64 "\n", line,
           sure_shape_name(shape), regime_name(which), seed, index);
    exit(EXIT_FAILURE);
}

static void start(pid_t *id, int process, sure_shape shape, regime which, uint64_t seed,
                  uint64_t end)
{
    *id = fork();
    if (*id < 0) {
        perror("fork");
        exit(EXIT_FAILURE);
    }
    if (*id > 0)
        return;
    signal(SIGINT, SIG_IGN);
    signal(SIGTERM, SIG_IGN);
    alarm(SECONDS_A_ROUND);
    work(process, shape, which, seed, end);
    _exit(EXIT_SUCCESS);
}

static void run(const options *wanted, sure_shape shape, regime which, uint64_t end,
                tally_record *record)
{
    pid_t ids[PROCESSES_MAX];
    pair_tally *total = &record->pairs[shape][which];
    fflush(stdout);
    atomic_store(&shared->next, total->cases);
    for (int p = 0; p < wanted->processes; p++)
        start(&ids[p], p, shape, which, record->seed, end);
    for (int p = 0; p < wanted->processes; p++) {
        int status;
        while (waitpid(ids[p], &status, 0) < 0 && errno == EINTR)
            continue;
        if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
            report_lost(p, shape, which, record->seed);
    }
    for (int p = 0; p < wanted->processes; p++)
        tally_add(total, &shared->process[p].sum);
}

static bool is_wanted(const options *wanted, sure_shape shape, regime which)
{
    return regime_applies(shape, which) &&
           (wanted->shape < 0 || (sure_shape)wanted->shape == shape) &&
           (wanted->regime < 0 || (regime)wanted->regime == which);
}

static void keep(const options *wanted, const tally_record *record)
{
    if (wanted->record && !tally_write(wanted->record, record)) {
        perror(wanted->record);
        exit(EXIT_FAILURE);
    }
}

static pair_tally sum_of(const tally_record *record)
{
    pair_tally sum = {0};
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++)
            tally_add(&sum, &record->pairs[shape][r]);
    }
    return sum;
}

/* Every pair to the part of its own number that `done` is of wanted->cases; false if it has to
 * end. */
static bool run_until(const options *wanted, uint64_t done, tally_record *record)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++) {
            if (!is_wanted(wanted, shape, r))
                continue;
            uint64_t end = quota(wanted, shape, r) * done / wanted->cases;
            if (record->pairs[shape][r].cases >= end)
                continue;
            run(wanted, shape, r, end, record);
            keep(wanted, record);
            if (interrupted || atomic_load(&shared->reports) >= REPORTS)
                return false;
        }
    }
    return true;
}

/* Of enough cases of each pair the reference sees some hit and some miss. */
static int count_one_sided(const tally_record *record)
{
    enum { ENOUGH = 1000 };
    int count = 0;
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++) {
            const pair_tally *pair = &record->pairs[shape][r];
            if (pair->cases < ENOUGH || (pair->hits > 0 && pair->misses > 0))
                continue;
            printf("%s %s: hits or misses alone\n", sure_shape_name(shape), regime_name(r));
            count++;
        }
    }
    return count;
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* In rounds, so that a campaign that is interrupted has gone everywhere. */
static void run_all(const options *wanted, tally_record *record)
{
    double began = seconds();
    uint64_t done = 0;
    bool going = true;
    while (going && done < wanted->cases) {
        done = wanted->cases - done > ROUND ? done + ROUND : wanted->cases;
        going = run_until(wanted, done, record);
        pair_tally sum = sum_of(record);
        fprintf(stderr,
                "%s %" PRIu64 " of %" PRIu64 ", %" PRIu64 " cases, %" PRIu64
                " broken promises, %.0f s\n",
                going ? "to" : "before", done, wanted->cases, sum.cases, sum.broken,
                seconds() - began);
    }
}

static void print_sum(const pair_tally *sum)
{
    printf("%" PRIu64 " cases: %" PRIu64 " hit, %" PRIu64 " miss, %" PRIu64 " invalid; %" PRIu64
           " normals, %" PRIu64 " intervals, %" PRIu64 " spawns; %" PRIu64
           " times half an ulp above the cap; %" PRIu64 " broken promises\n",
           sum->cases, sum->hits, sum->misses, sum->invalid, sum->normals, sum->intervals,
           sum->spawns, sum->out_of_cap, sum->broken);
    for (int i = 0; i < SURE_STAGES; i++) {
        printf("%-14s", sure_stage_name((sure_stage)i));
        for (sure_tier tier = SURE_TIER_CERTAIN; tier < SURE_TIERS; tier++)
            printf(" %s %9.5f %%", sure_tier_name(tier),
                   100.0 * (double)sum->tiers[tier].stages[i] / (double)sum->cases);
        printf("\n");
    }
}

static options read_options(int argc, char **argv)
{
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    long long cases = 10000, seed = 1;
    const char *chosen_shape = NULL, *chosen_regime = NULL;
    sure_shape shape = 0;
    regime which = 0;
    options wanted = {.processes = cores < PROCESSES_MAX ? (int)cores : PROCESSES_MAX};
    const struct poptOption known[] = {
        {"cases", 0, POPT_ARG_LONGLONG, &cases, 0, "of each pair", "N"},
        {"seed", 0, POPT_ARG_LONGLONG, &seed, 0, NULL, "S"},
        {"processes", 0, POPT_ARG_INT, &wanted.processes, 0, NULL, "P"},
        {"record", 0, POPT_ARG_STRING, &wanted.record, 0, NULL, "FILE"},
        {"shape", 0, POPT_ARG_STRING, &chosen_shape, 0, NULL, "NAME"},
        {"regime", 0, POPT_ARG_STRING, &chosen_regime, 0, NULL, "NAME"},
        POPT_TABLEEND};
    poptContext context = poptGetContext("campaign", argc, (const char **)argv, known, 0);
    bool good = poptGetNextOpt(context) == -1 && !poptPeekArg(context) && cases > 0 &&
                wanted.processes > 0 && wanted.processes <= PROCESSES_MAX &&
                (!chosen_shape || sure_shape_from_name(chosen_shape, &shape)) &&
                (!chosen_regime || regime_from_name(chosen_regime, &which));
    if (!good) {
        poptPrintUsage(context, stderr, 0);
        exit(2);
    }
    poptFreeContext(context);
    wanted.cases = (uint64_t)cases;
    wanted.seed = (uint64_t)seed;
    wanted.shape = chosen_shape ? (int)shape : -1;
    wanted.regime = chosen_regime ? (int)which : -1;
    return wanted;
}

int main(int argc, char **argv)
{
    static tally_record record;
    options wanted = read_options(argc, argv);
    record.seed = wanted.seed;
    if (wanted.record && (!tally_read(wanted.record, &record) || record.seed != wanted.seed)) {
        fprintf(stderr, "%s is no record of seed %" PRIu64 "\n", wanted.record, wanted.seed);
        return 2;
    }
    shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        perror("mmap");
        return EXIT_FAILURE;
    }
    struct sigaction action = {.sa_handler = interrupt};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    run_all(&wanted, &record);
    pair_tally sum = sum_of(&record);
    print_sum(&sum);
    if (interrupted)
        printf("interrupted%s\n",
               wanted.record ? "; the same command goes on from the record" : "");
    bool good = sum.broken == 0 && count_one_sided(&record) == 0;
    printf("%d passed, %d failed\n", good, !good);
    return good && !interrupted ? EXIT_SUCCESS : EXIT_FAILURE;
}
