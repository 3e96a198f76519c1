/* SPDX-License-Identifier: MIT */
/* The bench times what it says it times: its sums are those of the answers asked one by one. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "../support/suite.h"

#include "../../reference/peers/naive.h"
#include "../../reference/peers/naive_float.h"
#include "../../reference/peers/textbook_bench.h"
#include "../../src/cases/case_floats.h"
#include "../../src/judge/bench/bench.h"
#include "../../src/judge/bench/bench_cases.h"
#include "../../src/judge/bench/instructions.h"
#include "../../src/support/cpu_time.h"

/* Not a multiple of a turn. */
#define CASES 700

static const bench_plan short_plan = {.cases = CASES, .repeats = 5, .seconds = BENCH_SECONDS};

static bench_row measured(const bench_plan *plan, sure_shape shape, regime which)
{
    bench_row row;
    ck_assert(bench_measure(plan, shape, which, BENCH_MIXED, &row));
    return row;
}

#define NAIVE(shape, SHAPE)                                                                        \
    static sure_status ask_##shape(const sure_case *it, sure_hit *hit)                             \
    {                                                                                              \
        return naive_##shape##_hit(&it->ray, &it->object.as.shape, hit);                           \
    }
SURE_EACH_SHAPE(NAIVE)

static sure_status naive_hit(const sure_case *it, sure_hit *hit)
{
#define ASKER(shape, SHAPE) ask_##shape,
    static sure_status (*const askers[])(const sure_case *, sure_hit *) = {SURE_EACH_SHAPE(ASKER)};
    return askers[it->object.shape](it, hit);
}

static sure_status subject_hit(int subject, const sure_case *it, sure_hit *hit)
{
    if (subject == BENCH_NAIVE)
        return naive_hit(it, hit);
    return sure_object_hit(&it->ray, &it->object, (sure_tier)(subject - 1), hit);
}

SHAPE_TEST(every_subject_is_asked_every_case)
{
    bench_plan plan = short_plan;
    sure_shape shape = (sure_shape)_i;
    bench_row row = measured(&plan, shape, REGIME_GRAZING);
    ck_assert_int_eq(row.cases, CASES);
    ck_assert_int_eq(row.repeats, plan.repeats);
    for (int subject = 0; subject < BENCH_NAIVE_BLOCK; subject++) {
        uint64_t sum = 0, hits = 0;
        for (uint64_t i = 0; i < CASES; i++) {
            sure_case it = regime_case(shape, REGIME_GRAZING, 0, i);
            sure_hit hit = {0, 0, SURE_PART_SURFACE, 0};
            sure_status status = subject_hit(subject, &it, &hit);
            sum += bench_checksum(status, hit.t);
            hits += status == SURE_HIT;
        }
        ck_assert(row.results[subject].asked && row.results[subject].instructions == -1);
        ck_assert_uint_eq(row.results[subject].hits, hits);
        ck_assert_uint_eq(row.results[subject].checksum, sum);
    }
}

/* In floats the peers and what is public in floats. Of cases that floats can say. */
#define PEER_F(peer, shape)                                                                        \
    static sure_status peer##_##shape##_f(const float_query *it, sure_hit_f *hit)                  \
    {                                                                                              \
        return peer##_##shape##_hit_f(&it->ray, (const void *)it->object, hit);                    \
    }
#define PEERS_F(shape, SHAPE) PEER_F(naive, shape) PEER_F(textbook, shape)
SURE_EACH_SHAPE(PEERS_F)

static sure_status subject_hit_f(int subject, const float_query *it, sure_hit_f *hit)
{
#define NAIVE_F(shape, SHAPE) naive_##shape##_f,
#define TEXTBOOK_F(shape, SHAPE) textbook_##shape##_f,
    typedef sure_status asker(const float_query *, sure_hit_f *);
    static asker *const naive[] = {SURE_EACH_SHAPE(NAIVE_F)};
    static asker *const textbook[] = {SURE_EACH_SHAPE(TEXTBOOK_F)};
    if (subject == BENCH_NAIVE)
        return naive[it->shape](it, hit);
    if (subject == BENCH_TIER(SURE_TIER_TEXTBOOK))
        return textbook[it->shape](it, hit);
    return float_query_hit(it, (sure_tier)(subject - 1), hit);
}

SHAPE_TEST(every_subject_is_asked_every_float)
{
    bench_plan plan = short_plan;
    plan.floats = true;
    bench_row row = measured(&plan, (sure_shape)_i, REGIME_GRAZING);
    ck_assert_int_eq(row.cases, CASES);
    for (int subject = 0; subject < BENCH_NAIVE_BLOCK; subject++) {
        uint64_t sum = 0, hits = 0, asked = 0;
        const bool is_asked = subject == BENCH_NAIVE || subject == BENCH_TIER(SURE_TIER_TEXTBOOK) ||
                              subject > BENCH_TIER(SURE_TIER_STABLE);
        ck_assert(row.results[subject].asked == is_asked);
        for (uint64_t i = 0; asked < CASES && is_asked; i++) {
            sure_case it = regime_case((sure_shape)_i, REGIME_GRAZING, 0, i);
            sure_hit_f hit = {0};
            if (!float_case(&it, &it))
                continue;
            const float_query q = float_query_of(&it);
            sure_status status = subject_hit_f(subject, &q, &hit);
            sum += bench_checksum(status, (double)hit.t);
            hits += status == SURE_HIT;
            asked++;
        }
        ck_assert_uint_eq(row.results[subject].hits, hits);
        ck_assert_uint_eq(row.results[subject].checksum, sum);
    }
    const bench_result *textbook = &row.results[BENCH_TIER(SURE_TIER_TEXTBOOK)];
    ck_assert((float)textbook->over_textbook.median == 1); /* a sum of shares */
}

/* Before one object, and one ray before many objects, some hit and some miss; how many are asked in
 * a call makes no difference, nor does it whether they are many. */
SHAPE_TEST(blocks_of_any_size_answer_alike)
{
    for (int way = 0; way < 4; way++) {
        bench_plan plan = short_plan;
        plan.floats = way % 2 == 1;
        plan.objects = way >= 2;
        plan.block = 1;
        const bench_row alone = measured(&plan, (sure_shape)_i, REGIME_TYPICAL);
        plan.block = 100;
        const bench_row many = measured(&plan, (sure_shape)_i, REGIME_TYPICAL);
        const bench_result *one = &alone.results[BENCH_TIER(SURE_TIER_CERTAIN)];
        const bench_result *other = &many.results[BENCH_TIER(SURE_TIER_CERTAIN)];
        ck_assert(one->asked && other->asked);
        ck_assert_uint_eq(one->checksum, other->checksum);
        ck_assert_uint_gt(one->hits, CASES / 20);
        ck_assert_uint_lt(one->hits, CASES - CASES / 20);
        if (!plan.floats)
            ck_assert_uint_eq(one->hits, alone.results[BENCH_TIER(SURE_TIER_EXACT)].hits);
    }
}

static bool starts_within(const sure_case *it)
{
    const sure_ray start = {it->ray.origin, it->ray.direction, 0, 0};
    sure_interval chord;
    return sure_object_interval(&start, &it->object, SURE_TIER_EXACT, &chord) == SURE_HIT;
}

/* Which of a picture's cases a block has, and as what. */
static bool in_block(const sure_case *first, bool objects, sure_case *it)
{
    if (!objects)
        return case_same_object(it, first);
    if (starts_within(it))
        return false;
    *it = case_before_ray(it, &first->ray);
    return true;
}

static void check_blocks_of_pictures(sure_shape shape, bool objects)
{
    bench_plan plan = short_plan;
    plan.block = 100;
    plan.objects = objects;
    const bench_row row = measured(&plan, shape, REGIME_CAMERA);
    const sure_case first = regime_case(shape, REGIME_CAMERA, 0, 0);
    uint64_t sum = 0;
    int cases = 0;
    for (uint64_t i = 0; cases < row.cases; i++) {
        sure_case it = regime_case(shape, REGIME_CAMERA, 0, i);
        sure_hit hit = {.t = 0};
        if (!in_block(&first, objects, &it))
            continue;
        sure_status status = sure_object_hit(&it.ray, &it.object, SURE_TIER_CERTAIN, &hit);
        sum += bench_checksum(status, hit.t);
        cases++;
    }
    ck_assert_int_gt(row.cases, 0);
    ck_assert_uint_eq(row.results[BENCH_TIER(SURE_TIER_CERTAIN)].checksum, sum);
}

/* Of pictures a block has the rays that ask the first case's object, as they are; or before one ray
 * the objects that were not asked from within. */
SHAPE_TEST(blocks_of_pictures)
{
    check_blocks_of_pictures((sure_shape)_i, false);
    check_blocks_of_pictures((sure_shape)_i, true);
}

/* The books' routine in float is right about most ordinary rays, and about the last bit of t in at
 * least a twentieth of their hits (docs/peers.md has more than a tenth). */
SHAPE_TEST(textbook_in_float_answers)
{
    int asked = 0, agreed = 0, hits = 0, right = 0;
    for (uint64_t i = 0; asked < CASES; i++) {
        sure_case it = regime_case((sure_shape)_i, REGIME_TYPICAL, 0, i);
        if (!float_case(&it, &it))
            continue;
        const float_query q = float_query_of(&it);
        sure_hit_f hit = {0}, exact = {0};
        const sure_status status = subject_hit_f(BENCH_TIER(SURE_TIER_TEXTBOOK), &q, &hit);
        const bool same = status == float_query_hit(&q, SURE_TIER_EXACT, &exact);
        asked++;
        agreed += same;
        hits += same && status == SURE_HIT;
        right += same && status == SURE_HIT && hit.t == exact.t;
    }
    ck_assert_int_gt(agreed, CASES / 10 * 8);
    ck_assert_int_gt(hits, CASES / 20);
    ck_assert_int_gt(20 * right, hits);
}

/* The naive block does what the naive peer does ray by ray. */
SHAPE_TEST(the_naive_block_is_the_naive_peer)
{
    bench_plan plan = short_plan;
    plan.block = 100;
    const bench_row row = measured(&plan, (sure_shape)_i, REGIME_TYPICAL);
    const bench_result *block = &row.results[BENCH_NAIVE_BLOCK];
    ck_assert(block->asked == bench_has(&plan, BENCH_NAIVE_BLOCK));
    ck_assert(!block->asked || block->checksum == row.results[BENCH_NAIVE].checksum);
    ck_assert(!bench_has(&short_plan, BENCH_NAIVE_BLOCK));
}

static void check_figure(int count, double median, double lower, double upper)
{
    double values[16];
    for (int i = 0; i < count; i++)
        values[i] = 5 * i % count; /* 0, 1, ... in some order */
    const bench_figure found = bench_figure_of(values, count);
    ck_assert_double_eq(found.median, median);
    ck_assert_double_eq(found.lower, lower);
    ck_assert_double_eq(found.upper, upper);
}

/* A quarter of the others is below the lower one, and as many above the upper one. */
TEST(medians_and_quartiles)
{
    check_figure(1, 0, 0, 0);
    check_figure(2, 0.5, 0, 1);
    check_figure(3, 1, 0, 2);
    check_figure(4, 1.5, 0, 3);
    check_figure(9, 4, 2, 6);
    check_figure(12, 5.5, 2, 9);
    check_figure(13, 6, 3, 9);
}

/* A sum over two turns, weighed: some ten roundings of at most 2^-53 each. */
#define FEW_ROUNDINGS 0x1p-48

static void check_quotient(const bench_figure *ratio, double above, double below)
{
    double expected = above / below;
    ck_assert_double_eq_tol(ratio->median, expected, FEW_ROUNDINGS * expected);
    ck_assert(ratio->lower == ratio->median && ratio->median == ratio->upper);
}

/* With one repeat no median hides it. */
TEST(ratios_are_those_of_the_times)
{
    bench_plan plan = short_plan;
    plan.repeats = 1;
    bench_row row = measured(&plan, SURE_SHAPE_CONE, REGIME_TYPICAL);
    double naive = row.results[BENCH_NAIVE].nanoseconds.median;
    double textbook = row.results[BENCH_TIER(SURE_TIER_TEXTBOOK)].nanoseconds.median;
    for (int subject = 0; subject < BENCH_NAIVE_BLOCK; subject++) {
        const bench_result *result = &row.results[subject];
        check_quotient(&result->over_naive, result->nanoseconds.median, naive);
        check_quotient(&result->over_textbook, result->nanoseconds.median, textbook);
        check_quotient(&result->over_faster, result->nanoseconds.median, fmin(naive, textbook));
    }
}

/* Hits or misses alone, as many as the plan wants or as there are among 64 times as many. */
SHAPE_TEST(rays_of_one_kind)
{
    for (bench_rays rays = BENCH_HITS; rays <= BENCH_MISSES; rays++) {
        bench_row row;
        ck_assert(bench_measure(&short_plan, (sure_shape)_i, REGIME_CAMERA, rays, &row));
        ck_assert_int_eq(row.cases, CASES);
        ck_assert_int_eq(row.rays, rays);
        for (sure_tier tier = SURE_TIER_CERTAIN; tier < SURE_TIERS; tier++)
            ck_assert_uint_eq(row.results[BENCH_TIER(tier)].hits, rays == BENCH_HITS ? CASES : 0);
    }
}

/* In one order they are what they are in another. */
SHAPE_TEST(repeated_rays_are_the_mixed_ones)
{
    bench_row mixed = measured(&short_plan, (sure_shape)_i, REGIME_TYPICAL), repeated;
    ck_assert(
        bench_measure(&short_plan, (sure_shape)_i, REGIME_TYPICAL, BENCH_REPEATED, &repeated));
    ck_assert_int_eq(repeated.cases, CASES);
    for (int subject = 0; subject < BENCH_NAIVE_BLOCK; subject++) {
        ck_assert(repeated.results[subject].asked);
        ck_assert_uint_eq(repeated.results[subject].hits, mixed.results[subject].hits);
        ck_assert_uint_eq(repeated.results[subject].checksum, mixed.results[subject].checksum);
    }
}

/* Only those of the plan and the two that all are compared with. */
TEST(only_the_plan_is_asked)
{
    bench_plan plan = short_plan;
    plan.only = 1u << BENCH_TIER(SURE_TIER_FLOAT32);
    bench_row row = measured(&plan, SURE_SHAPE_DISC, REGIME_TYPICAL);
    for (int subject = 0; subject < BENCH_NAIVE_BLOCK; subject++)
        ck_assert_int_eq(row.results[subject].asked, subject == BENCH_NAIVE ||
                                                         subject == BENCH_TIER(SURE_TIER_FLOAT32) ||
                                                         subject == BENCH_TIER(SURE_TIER_TEXTBOOK));
}

/* A slow row ends early, but not before its median means something. */
TEST(a_row_ends_in_time)
{
    bench_plan plan = short_plan;
    plan.repeats = 1000;
    plan.seconds = 0;
    ck_assert_int_eq(measured(&plan, SURE_SHAPE_PLANE, REGIME_TYPICAL).repeats, 3);
}

/* With three repeats all are enough; with more, some may have been noisy, but not all. */
TEST(the_share_that_counts)
{
    bench_plan plan = short_plan;
    ck_assert_double_gt(measured(&plan, SURE_SHAPE_PLANE, REGIME_TYPICAL).quiet, 0.59);
    plan.repeats = 3;
    ck_assert_double_eq(measured(&plan, SURE_SHAPE_PLANE, REGIME_TYPICAL).quiet, 1);
}

TEST(what_counts_as_quiet)
{
    const double noise[] = {1, 1.09, 1.11, 1.5, 2};
    ck_assert_int_eq(noise_quiet(noise, 5, 1), 2);
    ck_assert_int_eq(noise_quiet(noise, 5, 2), 2);
    ck_assert_int_eq(noise_quiet(noise, 5, 3), 3);
    ck_assert_int_eq(noise_quiet(noise, 5, 5), 5);
    ck_assert_int_eq(noise_quiet(noise + 3, 1, 3), 1);
    const double alike[] = {1, 1.5, 1.5, 1.6};
    ck_assert_int_eq(noise_quiet(alike, 4, 2), 3);
}

/* The least of a thousand, in nanoseconds. */
static double least_time(double (*call)(void))
{
    double least = INFINITY;
    for (int i = 0; i < 1000; i++) {
        double start = cpu_time();
        double noise = call();
        least = fmin(least, cpu_time() - start);
        ck_assert_double_ge(noise, 1);
    }
    return least;
}

/* What a probe costs without its 24,000 operations. */
static double nothing(void)
{
    double start = cpu_time();
    return cpu_time() >= start;
}

/* 24,000 operations take some time, unless the compiler has left them out. */
static void do_nothing(void *context)
{
    (void)context;
}

/* The least of many, which others on the machine do not change. */
TEST(measuring_itself_costs_nothing)
{
    enum { TIMES = 10000 };
    double cost = INFINITY, clock = INFINITY;
    for (int i = 0; i < TIMES; i++) {
        const double start = cpu_time();
        clock = fmin(clock, cpu_time() - start);
        cost = fmin(cost, cost_of(do_nothing, NULL));
    }
    ck_assert_double_ge(cost, 0);
    ck_assert_double_le(cost, clock / 2);
}

TEST(a_probe_works)
{
    noise_probe();
    ck_assert_double_gt(least_time(noise_probe), least_time(nothing) + 300);
}

/* The peers do the work they stand for: where nothing is nearly parallel, tangent or cut off, their
 * status and part are right. A miss leaves the hit. */
SHAPE_TEST(peers_are_right_on_typical_cases)
{
    uint64_t differ = 0, hits = 0;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_case it = regime_case((sure_shape)_i, REGIME_TYPICAL, 7, i);
        sure_case grazing = regime_case((sure_shape)_i, REGIME_GRAZING, 0, i);
        sure_hit naive = {0, 0, SURE_PART_SURFACE, 0}, textbook = naive;
        sure_hit before = {-1, -2, SURE_PART_TOP, 0}, after = before;
        if (naive_hit(&grazing, &after) != SURE_HIT)
            ck_assert_mem_eq(&after, &before, sizeof before);
        sure_status status = naive_hit(&it, &naive);
        sure_status right = sure_object_hit(&it.ray, &it.object, SURE_TIER_TEXTBOOK, &textbook);
        hits += status == SURE_HIT;
        differ += status != right || naive.part != textbook.part;
    }
    ck_assert_uint_gt(hits, 800);
    ck_assert_uint_lt(hits, 1400);
    ck_assert_uint_eq(differ, 0);
}

SUITE("bench")
