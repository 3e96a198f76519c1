/* SPDX-License-Identifier: MIT */
/* Walks: who is right goes on for ever, who is not is found; the places where they are. */
#include "suite.h"
#include "walk.h"

enum { ROWS = SURE_SHAPES * WALK_KINDS };

static truth exactly;

static walk_plan plan_of(sure_tier tier, double nudge, uint64_t steps)
{
    return (walk_plan){.by = {.tier = tier, .nudge = nudge}, .steps = steps, .threads = 1};
}

static uint64_t faults_in(const walk_plan *plan, sure_shape shape, walk_kind kind, walk_sum *sum)
{
    char message[CANDIDATE_MESSAGE];
    uint64_t all = 0;
    ck_assert(walk_steps(plan, &exactly, shape, kind, sum, message));
    ck_assert_uint_ge(sum->steps, plan->steps);
    ck_assert_uint_gt(sum->walks, 0);
    for (int i = 0; i < WALK_FAULTS; i++)
        all += sum->faults[i];
    return all;
}

/* Are there faults in every row of kinds `first` to `last`, or in none? Their steps. */
static uint64_t walk_all(const walk_plan *plan, walk_kind first, walk_kind last, bool to_be_found)
{
    uint64_t steps = 0;
    for (int row = 0; row < ROWS; row++) {
        walk_kind kind = (walk_kind)(row % WALK_KINDS);
        sure_shape shape = (sure_shape)(row / WALK_KINDS);
        walk_sum sum;
        if (kind < first || kind > last || !walk_kind_applies(shape, kind))
            continue;
        uint64_t faults = faults_in(plan, shape, kind, &sum);
        ck_assert_msg((faults > 0) == to_be_found, "%s %s: %" PRIu64, sure_shape_name(shape),
                      walk_kind_names[kind], faults);
        steps += sum.steps;
    }
    return steps;
}

TEST(test_certain_goes_on)
{
    const walk_plan plan = plan_of(SURE_TIER_CERTAIN, NAN, 5000);
    ck_assert_uint_gt(walk_all(&plan, WALK_ALONE, WALK_GRAZING, false), 100000);
}

TEST(test_exact_goes_on)
{
    const walk_plan plan = plan_of(SURE_TIER_EXACT, NAN, 500);
    walk_all(&plan, WALK_ALONE, WALK_GRAZING, false);
}

/* The rounded hit point itself is no place to start from. */
TEST(test_no_nudge_is_found)
{
    const walk_plan plan = plan_of(SURE_TIER_EXACT, 0, 500);
    walk_all(&plan, WALK_ALONE, WALK_GRAZING, true);
}

/* Absolute tolerances do where all is as usual, and fail where it is far or grazing, whoever
 * answers. */
TEST(test_nudges_are_found)
{
    static const double nudges[] = {1e-9, 1e-6};
    for (size_t i = 0; i < sizeof nudges / sizeof *nudges; i++) {
        const walk_plan sure = plan_of(SURE_TIER_CERTAIN, nudges[i], 1000);
        const walk_plan plain = plan_of(SURE_TIER_TEXTBOOK, nudges[i], 1000);
        walk_all(&sure, WALK_ALONE, WALK_ALONE, false);
        walk_all(&sure, WALK_FAR, WALK_GRAZING, true);
        walk_all(&plain, WALK_ALONE, WALK_ALONE, false);
        walk_all(&plain, WALK_FAR, WALK_GRAZING, true);
    }
}

/* Who finds nothing, or what is not there; who stays, or goes too far. */
typedef struct {
    sure_status status;
    double t;
    walk_fault found;
} simple_answer;

static const simple_answer *answering;

static candidate_end answer_simply(candidate *self, block *asked, int first, int count)
{
    (void)self;
    for (int i = first; i < first + count; i++)
        asked->replies[i] = (reply){.status = answering->status, .t = answering->t};
    return (candidate_end){.kind = REPLY_ANSWERED};
}

TEST(test_each_fault_is_found)
{
    static const simple_answer answers[] = {{SURE_MISS, 0, WALK_LOST},
                                            {SURE_HIT, 1, WALK_GHOST},
                                            {SURE_HIT, 0x1p-40, WALK_ZERO},
                                            {SURE_HIT, 16, WALK_PAST}, /* the way is below 4 */
                                            {SURE_HIT, 0x1p40, WALK_PAST}};
    candidate simple = {.block_cases = BLOCK_CASES, .ask = answer_simply};
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++) {
        walk_plan plan = plan_of(SURE_TIER_CERTAIN, 0x1p-40, 1000);
        walk_sum sum;
        plan.by.asked = &simple;
        answering = &answers[i];
        faults_in(&plan, SURE_SHAPE_SPHERE, WALK_BESIDE, &sum);
        ck_assert_uint_gt(sum.faults[answering->found], 50); /* of 1000 */
    }
}

/* Who goes so many times as far as is right. */
static double times;

static candidate_end answer_scaled(candidate *self, block *asked, int first, int count)
{
    (void)self;
    for (int i = first; i < first + count; i++) {
        const sure_case *one = &asked->cases[i];
        sure_hit hit = {.t = 0};
        sure_status status = sure_object_hit(&one->ray, &one->object, SURE_TIER_EXACT, &hit);
        asked->replies[i] = (reply){.status = status, .t = times * hit.t};
    }
    return (candidate_end){.kind = REPLY_ANSWERED};
}

/* Not even half as far, or more than twice; who is between them has lost the side alone. */
TEST(test_how_far_is_too_far)
{
    static const struct {
        double times;
        bool zero, past;
    } ways[] = {{0.4, true, false}, {0.6, false, false}, {1.9, false, false}, {2.1, false, true}};
    candidate scaled = {.block_cases = BLOCK_CASES, .ask = answer_scaled};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        walk_plan plan = plan_of(SURE_TIER_CERTAIN, 0x1p-40, 1000);
        walk_sum sum;
        plan.by.asked = &scaled;
        times = ways[i].times;
        ck_assert_uint_gt(faults_in(&plan, SURE_SHAPE_SPHERE, WALK_ALONE, &sum), 50);
        ck_assert_int_eq(sum.faults[WALK_ZERO] > 0, ways[i].zero);
        ck_assert_int_eq(sum.faults[WALK_PAST] > 0, ways[i].past);
    }
}

TEST(test_threads_change_nothing)
{
    walk_plan plan = plan_of(SURE_TIER_TEXTBOOK, 1e-9, 200000);
    walk_sum one, two, other;
    faults_in(&plan, SURE_SHAPE_SPHERE, WALK_GRAZING, &one);
    plan.threads = 2;
    faults_in(&plan, SURE_SHAPE_SPHERE, WALK_GRAZING, &two);
    ck_assert_mem_eq(one.faults, two.faults, sizeof one.faults);
    ck_assert_uint_eq(one.steps, two.steps);
    ck_assert_uint_eq(one.walks, two.walks);
    plan.steps = 65536;
    faults_in(&plan, SURE_SHAPE_SPHERE, WALK_GRAZING, &other);
    for (int i = 0; i < WALK_FAULTS; i++) { /* the first one is that of the first steps */
        if (other.faults[i] > 0)
            ck_assert_mem_eq(&other.first[i], &two.first[i], sizeof two.first[i]);
    }
    plan.steps = 200000;
    plan.seed = 1;
    faults_in(&plan, SURE_SHAPE_SPHERE, WALK_GRAZING, &other);
    ck_assert_mem_ne(one.faults, other.faults, sizeof one.faults);
}

/* Of two solids the second lies in the first, or has no more than an end of a chord in common. */
static sure_interval chord(const sure_ray *ray, const sure_object *solid, bool *met)
{
    sure_interval ends = {.t_enter = 0, .t_leave = 0};
    *met = sure_object_interval(ray, solid, SURE_TIER_EXACT, &ends) == SURE_HIT;
    return ends;
}

LOOP_TEST(test_settings, ROWS)
{
    sure_shape shape = (sure_shape)(_i / WALK_KINDS);
    walk_kind kind = (walk_kind)(_i % WALK_KINDS);
    int both = 0;
    for (uint64_t n = 0;
         n < 500 && kind >= WALK_NESTED && kind <= WALK_BESIDE && walk_kind_applies(shape, kind);
         n++) {
        rng g = rng_of(3, shape, (uint64_t)kind, n);
        setting in = setting_of(shape, kind, &g);
        bool met[WALK_SOLIDS];
        sure_ray ray = {in.start, rng_unit(&g), 0, INFINITY};
        sure_interval first = chord(&ray, &in.solids[0], &met[0]);
        sure_interval second = chord(&ray, &in.solids[1], &met[1]);
        both += met[0] && met[1];
        if (kind == WALK_BESIDE)
            ck_assert(!met[1] || second.t_enter >= first.t_leave ||
                      second.t_leave <= first.t_enter);
        else
            ck_assert(!met[1] ||
                      (second.t_enter >= first.t_enter && second.t_leave <= first.t_leave));
    }
    if (kind >= WALK_NESTED && kind <= WALK_BESIDE && walk_kind_applies(shape, kind))
        ck_assert_int_gt(both, 0);
}

SUITE("walk")
