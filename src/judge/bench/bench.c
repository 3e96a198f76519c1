/* SPDX-License-Identifier: MIT */
#include "bench_cases.h"
#include "bench_turn.h"

#include "instructions.h"

#include "../../support/cpu_time.h"
#include "../../support/median.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Noise. */

#define STEPS 2000
#define WARM_UP 100

/* Six chains that do not wait for each other: more work at once than there are units for it. */
static double probe(void)
{
    static volatile uint64_t kept;
    uint64_t a = 1 + kept, b = 2 + a, c = 3 + b, d = 4 + c, e = 5 + d, f = 6 + e;
    double start = cpu_time();
    for (int i = 0; i < STEPS; i++) {
        a += a >> 3;
        b ^= b << 5;
        c -= c >> 7;
        d ^= d >> 9;
        e += e << 2;
        f ^= f << 11;
    }
    kept = (a ^ b ^ c ^ d ^ e ^ f) & 1;
    return cpu_time() - start;
}

double noise_probe(void)
{
    static double least = INFINITY;
    for (int i = 0; i < WARM_UP && least == INFINITY; i++)
        probe();
    double time = probe();
    least = fmin(least, time);
    return least > 0 ? time / least : 1; /* 0 by a coarse clock */
}

int noise_quiet(const double *noise, int count, int enough)
{
    int quiet = enough < count ? enough : count;
    double limit = fmax(NOISE_MOST, noise[quiet - 1]);
    while (quiet < count && noise[quiet] <= limit)
        quiet++;
    return quiet;
}

typedef struct {
    const bench_turn *turn;
    int subject;
    answers given;
} asking;

static void ask(void *context)
{
    asking *one = context;
    one->given = bench_ask(one->turn, one->subject);
}

const char *bench_subject_name(int subject)
{
    if (subject == BENCH_NAIVE_BLOCK)
        return "naive block";
    return subject == BENCH_NAIVE ? "naive" : sure_tier_name((sure_tier)(subject - 1));
}

bool bench_shows(const bench_plan *plan, int subject)
{
    return bench_has(plan, subject) && (!plan->only || (plan->only >> subject & 1) == 1 ||
                                        subject == BENCH_NAIVE || subject == BENCH_NAIVE_BLOCK);
}

/* The turns. */

#define LEAST_REPEATS 3
#define PATIENCE 1e3 /* nanoseconds for each answer of a row, to take noisy turns again */

/* A turn in a repeat; turns are sorted by what stands first. */
typedef struct {
    double noise, nanoseconds[BENCH_SUBJECTS];
} sample;

/* Of the other cases so many may come before one that is wanted. */
#define SEARCHED 64

typedef struct {
    const bench_plan *plan;
    sure_shape shape;
    bool one_order;
    sure_case *cases;
    bench_turn *now;
    int count, turns;
    int subjects[BENCH_SUBJECTS], subject_count;
    answers answers[BENCH_SUBJECTS]; /* of the last repeat */
    int most_repeats, repeats;
    sample *samples; /* of turn and repeat */
    double patience; /* nanoseconds that may still be spent on noisy turns */
    int *quiet;      /* of a turn: how many repeats count, which are then the first */
    double *room;    /* for most_repeats numbers */
} contest;

static sample *samples_of(const contest *all, int turn)
{
    return all->samples + (size_t)turn * (size_t)all->most_repeats;
}

/* Who begins changes from turn to turn, the direction from repeat to repeat. Cases are
 * brought into the cache before, so that nobody pays for being first. */
static sample take_turns(contest *all, int turn, int repeat, rng *d, answers *given)
{
    int count = all->subject_count, most = turn_size(all->plan), left = all->count - turn * most;
    int size = left < most ? left : most;
    sure_case *cases = all->cases + (size_t)turn * (size_t)most;
    if (!all->one_order)
        shuffle_cases(cases, size, d);
    all->now->plan = all->plan;
    all->now->shape = all->shape;
    all->now->count = size;
    all->now->cases = cases;
    bench_turn_fill(all->now);
    sample taken = {.noise = noise_probe()};
    for (int i = 0; i < count; i++) {
        int place = (turn + repeat / 2 + i) % count;
        int subject = all->subjects[repeat % 2 == 0 ? place : count - 1 - place];
        asking one = {all->now, subject, {0, 0}};
        const double cost = cost_of(ask, &one);
        taken.nanoseconds[subject] = cost == 0 ? 1 : cost; /* no share of nothing is a number */
        given[subject] = one.given;
        taken.noise = fmax(taken.noise, noise_probe());
    }
    return taken;
}

/* A noisy turn is taken again, as long as there is patience. */
static void repeat_once(contest *all, int repeat, rng *d)
{
    memset(all->answers, 0, sizeof all->answers);
    for (int turn = 0; turn < all->turns; turn++) {
        answers given[BENCH_SUBJECTS] = {{0, 0}};
        sample *taken = &samples_of(all, turn)[repeat];
        double start = cpu_time();
        while ((*taken = take_turns(all, turn, repeat, d, given)).noise > NOISE_MOST &&
               all->patience > 0) {
            all->patience -= cpu_time() - start;
            start = cpu_time();
        }
        for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
            all->answers[subject].sum += given[subject].sum;
            all->answers[subject].hits += given[subject].hits;
        }
    }
}

/* A first repeat warms the machine up and is overwritten. */
static void repeat_all(contest *all, double seconds)
{
    rng d = rng_of(1, 0, 0, 0);
    double start = cpu_time();
    repeat_once(all, 0, &d);
    while (all->repeats < all->most_repeats &&
           (all->repeats < LEAST_REPEATS || cpu_time() - start < seconds * 1e9))
        repeat_once(all, all->repeats++, &d);
}

/* What counts: a turn's quiet repeats. */

static void find_quiet(contest *all)
{
    for (int turn = 0; turn < all->turns; turn++) {
        sample *samples = samples_of(all, turn);
        qsort(samples, (size_t)all->repeats, sizeof *samples, by_size);
        for (int i = 0; i < all->repeats; i++)
            all->room[i] = samples[i].noise;
        all->quiet[turn] = noise_quiet(all->room, all->repeats, LEAST_REPEATS);
    }
}

/* The figures. A turn's times are compared repeat by repeat and the median is taken turn by turn:
 * it forgets what interrupted a repeat, but no case that is slow every time. */

bench_figure bench_figure_of(double *values, int count)
{
    sort_doubles(values, count);
    return (bench_figure){
        .median = (values[(count - 1) / 2] + values[count / 2]) / 2,
        .lower = values[(count - 1) / 4],
        .upper = values[count - 1 - (count - 1) / 4],
    };
}

/* Of a subject's times, over another's where there is one (-1: none). */
static bench_figure figure_of(const contest *all, int turn, int subject, int other)
{
    const sample *samples = samples_of(all, turn);
    double *room = all->room;
    int count = all->quiet[turn];
    for (int i = 0; i < count; i++) {
        const double *times = samples[i].nanoseconds;
        room[i] = other < 0 ? times[subject] : times[subject] / times[other];
    }
    return bench_figure_of(room, count);
}

static void figure_add(bench_figure *sum, bench_figure more, double weight)
{
    sum->median += weight * more.median;
    sum->lower += weight * more.lower;
    sum->upper += weight * more.upper;
}

static bench_figure nanoseconds_of(const contest *all, int subject)
{
    bench_figure sum = {0, 0, 0};
    for (int turn = 0; turn < all->turns; turn++)
        figure_add(&sum, figure_of(all, turn, subject, -1), 1 / (double)all->count);
    return sum;
}

/* The turns' ratios, weighed by what each turn costs the other subject. */
static bench_figure ratio_of(const contest *all, int subject, int other)
{
    bench_figure sum = {0, 0, 0};
    double whole = nanoseconds_of(all, other).median * all->count;
    for (int turn = 0; turn < all->turns; turn++)
        figure_add(&sum, figure_of(all, turn, subject, other),
                   figure_of(all, turn, other, -1).median / whole);
    return sum;
}

static void set_results(const contest *all, bench_row *row)
{
    const int naive = BENCH_NAIVE;
    const bool has_textbook = bench_has(all->plan, BENCH_TIER(SURE_TIER_TEXTBOOK));
    const int textbook = has_textbook ? BENCH_TIER(SURE_TIER_TEXTBOOK) : naive;
    const bool beside_block = bench_shows(all->plan, BENCH_NAIVE_BLOCK);
    const bench_figure none = {NAN, NAN, NAN};
    bool by_naive = nanoseconds_of(all, naive).median < nanoseconds_of(all, textbook).median;
    row->repeats = all->repeats;
    for (int turn = 0; turn < all->turns; turn++)
        row->quiet += all->quiet[turn];
    row->quiet /= (double)all->turns * all->repeats;
    for (int i = 0; i < all->subject_count; i++) {
        int subject = all->subjects[i];
        row->results[subject] = (bench_result){
            .asked = true,
            .nanoseconds = nanoseconds_of(all, subject),
            .over_naive = ratio_of(all, subject, naive),
            .over_textbook = ratio_of(all, subject, textbook),
            .over_faster = ratio_of(all, subject, by_naive ? naive : textbook),
            .over_block = beside_block ? ratio_of(all, subject, BENCH_NAIVE_BLOCK) : none,
            .instructions = instructions_figure(nanoseconds_of(all, subject).median),
            .hits = all->answers[subject].hits,
            .checksum = all->answers[subject].sum,
        };
    }
}

const char *const bench_rays_names[] = {"mixed", "hits", "misses", "repeated", NULL};

static bool is_wanted(const sure_case *question, bench_rays rays)
{
    static const sure_status wanted[BENCH_RAYS] = {[BENCH_MIXED] = SURE_INVALID,
                                                   [BENCH_REPEATED] = SURE_INVALID, /* both */
                                                   [BENCH_HITS] = SURE_HIT,
                                                   [BENCH_MISSES] = SURE_MISS};
    return wanted[rays] == SURE_INVALID || sure_object_occluded(&question->ray, &question->object,
                                                                SURE_TIER_CERTAIN) == wanted[rays];
}

static bool starts_within(const sure_case *question)
{
    sure_ray start = question->ray;
    sure_interval chord;
    start.t_min = start.t_max = 0;
    return sure_object_interval(&start, &question->object, SURE_TIER_CERTAIN, &chord) == SURE_HIT;
}

/* A case as the plan asks it, of the first one's object or ray. One of a picture that has left a
 * surface would start beside it by roundings: before one object are the rays that ask it there, and
 * before one ray no objects that were asked from within. False: it can't be asked so. */
static bool make_case(const contest *all, bool of_picture, const sure_case *first, sure_case *made)
{
    const bench_plan *plan = all->plan;
    if (plan->block > 0 && of_picture &&
        (plan->objects ? starts_within(made) : !case_same_object(made, first)))
        return false;
    if (plan->block > 0 && plan->objects)
        *made = case_before_ray(made, &first->ray);
    else if (plan->block > 0 && !of_picture)
        *made = case_before_object(made, &first->object);
    return !plan->floats || float_case(made, made);
}

static void set_cases(contest *all, regime which, bench_rays rays, int most)
{
    const sure_case first = regime_case(all->shape, which, 0, 0);
    const bool of_picture = which == REGIME_CAMERA; /* its cases take long to make */
    uint64_t end = (uint64_t)most * (of_picture ? SEARCHED / 8 : SEARCHED);
    for (uint64_t i = 0; i < end && all->count < most; i++) {
        sure_case *made = &all->cases[all->count];
        *made = regime_case(all->shape, which, 0, i);
        if (make_case(all, of_picture, &first, made))
            all->count += is_wanted(made, rays);
    }
    all->turns = (all->count + turn_size(all->plan) - 1) / turn_size(all->plan);
}

static bool set_memory(contest *all, int cases)
{
    size_t size = (size_t)turn_size(all->plan), turns = ((size_t)cases + size - 1) / size;
    size_t repeats = (size_t)all->most_repeats;
    all->cases = malloc((size_t)cases * sizeof *all->cases);
    all->samples = malloc(turns * repeats * sizeof *all->samples);
    all->quiet = malloc(turns * sizeof *all->quiet);
    all->room = malloc(repeats * sizeof *all->room);
    all->now = aligned_alloc(_Alignof(bench_turn), sizeof *all->now);
    return all->now && all->cases && all->samples && all->quiet && all->room;
}

bool bench_measure(const bench_plan *plan, sure_shape shape, regime which, bench_rays rays,
                   bench_row *row)
{
    contest all = {.plan = plan,
                   .shape = shape,
                   .one_order = rays == BENCH_REPEATED,
                   .most_repeats = plan->repeats};
    *row = (bench_row){.shape = shape, .which = which, .rays = rays};
    for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
        if (bench_shows(plan, subject) ||
            (subject == BENCH_TIER(SURE_TIER_TEXTBOOK) && bench_has(plan, subject)))
            all.subjects[all.subject_count++] = subject;
    }
    double answers_asked = (double)all.subject_count * plan->cases * plan->repeats;
    all.patience = fmin(PATIENCE * answers_asked, plan->seconds * 1e9 / 2);
    bool possible = set_memory(&all, plan->cases);
    if (possible)
        set_cases(&all, which, rays, plan->cases);
    row->cases = all.count;
    if (all.count > 0) {
        repeat_all(&all, plan->seconds);
        find_quiet(&all);
        set_results(&all, row);
    }
    free(all.now);
    free(all.room);
    free(all.quiet);
    free(all.samples);
    free(all.cases);
    return possible;
}
