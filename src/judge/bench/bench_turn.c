/* SPDX-License-Identifier: MIT */
#include "bench_turn.h"

#include "../../../reference/peers/naive.h"
#include "../../../reference/peers/naive_block.h"
#include "../../../reference/peers/naive_float.h"
#include "../../../reference/peers/textbook_bench.h"
#include "../../numbers/bits.h"

#include <surehit/many.h>

bool bench_has(const bench_plan *plan, int subject)
{
    if (subject == BENCH_NAIVE_BLOCK)
        return plan->block > 0 && !plan->floats && !plan->objects &&
               naive_hits_of(SURE_SHAPE_SPHERE);
    const bool alone = plan->block == 0 && (subject == BENCH_TIER(SURE_TIER_TEXTBOOK) ||
                                            subject == BENCH_TIER(SURE_TIER_EXACT));
    return !plan->floats || alone || subject == BENCH_NAIVE ||
           subject == BENCH_TIER(SURE_TIER_CERTAIN);
}

void bench_turn_fill(bench_turn *turn)
{
    const int numbers = turn->plan->objects ? sure_shape_info_of(turn->shape)->numbers : 0;
    for (int i = 0; i < turn->count; i++) {
        const sure_case *c = &turn->cases[i];
        const double *ray = (const double *)(const void *)&c->ray;
        if (turn->plan->floats) {
            turn->floats[i] = float_query_of(c);
            for (int k = 0; k < 8; k++)
                turn->rays.of_float[k][i] = ((const float *)(const void *)&turn->floats[i].ray)[k];
            for (int k = 0; k < numbers; k++)
                turn->objects.of_float[k][i] = turn->floats[i].object[k];
            continue;
        }
        for (int k = 0; k < 8; k++)
            turn->rays.of_double[k][i] = ray[k];
        for (int k = 0; k < numbers; k++)
            turn->objects.of_double[k][i] = ((const double *)(const void *)&c->object.as)[k];
    }
}

static inline void add_answer(answers *all, sure_status status, double t)
{
    all->sum += bench_checksum(status, t);
    all->hits += status == SURE_HIT;
}

/* The routines, each called as all are called: through a pointer, one ray a call. */

#define TIERS(X, shape)                                                                            \
    X(shape, float32) X(shape, textbook) X(shape, stable) X(shape, certain) X(shape, exact)

#define ONE(shape, tier) +1
_Static_assert(TIERS(ONE, ) == SURE_TIERS, "every tier is measured");

/* `in`: nothing, or _f for floats. */
#define ASK_IN(shape, in, query, of, ...)                                                          \
    typedef sure_status shape##_routine##in(const sure_ray##in *, const sure_##shape##in *,        \
                                            sure_hit##in *);                                       \
    static answers ask_##shape##in(int subject, const query *asked, int count)                     \
    {                                                                                              \
        static shape##_routine##in *const routines[BENCH_SUBJECTS] = {__VA_ARGS__};                \
        shape##_routine##in *const routine = routines[subject];                                    \
        answers all = {0, 0};                                                                      \
        _Alignas(64) sure_hit##in hit = {.t = 0}; /* in one line of the cache */                   \
        for (int i = 0; i < count; i++) {                                                          \
            sure_status status = routine(&asked[i].ray, (const void *)&asked[i].of, &hit);         \
            add_answer(&all, status, (double)hit.t);                                               \
        }                                                                                          \
        return all;                                                                                \
    }
#define ROUTINE(shape, tier) sure_##shape##_hit_##tier,
#define ASK(shape, SHAPE)                                                                          \
    ASK_IN(shape, , sure_case, object.as, naive_##shape##_hit, TIERS(ROUTINE, shape))              \
    ASK_IN(shape, _f, float_query, object, [BENCH_NAIVE] = naive_##shape##_hit_f,                  \
           [BENCH_TIER(SURE_TIER_TEXTBOOK)] = textbook_##shape##_hit_f,                            \
           [BENCH_TIER(SURE_TIER_CERTAIN)] = sure_##shape##_hit_certain_f,                         \
           [BENCH_TIER(SURE_TIER_EXACT)] = sure_##shape##_hit_exact_f)
SURE_EACH_SHAPE(ASK)

/* Many rays a call. */

/* From number `from` on of columns that stand one behind the other. */
static void columns_from(const void *first, size_t size, int from, size_t count,
                         sure_numbers *columns)
{
    for (size_t k = 0; k < count; k++)
        columns[k] = (sure_numbers){
            (const char *)first + (k * BENCH_BLOCK_MOST + (size_t)from) * size, (ptrdiff_t)size};
}

/* What call `from` asks: all rays and the first object, or the first ray and all objects. */
static void asked_from(const bench_turn *turn, size_t size, int from, sure_rays *rays,
                       sure_objects *objects)
{
    if (turn->plan->objects) {
        const size_t numbers = (size_t)sure_shape_info_of(turn->shape)->numbers;
        *rays = turn->plan->floats ? sure_rays_of_f(&turn->floats[0].ray, 0)
                                   : sure_rays_of(&turn->cases[0].ray, 0);
        objects->shape = turn->shape;
        columns_from(&turn->objects, size, from, numbers, objects->numbers);
        return;
    }
    *objects = turn->plan->floats ? sure_objects_of_f(turn->shape, turn->floats[0].object, 0)
                                  : sure_objects_of(turn->shape, &turn->cases[0].object.as, 0);
    columns_from(&turn->rays, size, from, 8, (void *)rays);
}

/* The naive block, as asked. */
static void ask_naive_block(const bench_turn *turn, int from, int count, uint8_t *status,
                            uint8_t *part, double *t)
{
    const double *ray[8];
    for (int k = 0; k < 8; k++)
        ray[k] = &turn->rays.of_double[k][from];
    naive_hits_of(turn->shape)((size_t)count, ray, &turn->cases[0].object.as, status, part, t);
}

/* The rest of add_answer: bytes are best added among themselves, so that reading takes little of
 * what is measured. */
static void add_statuses(answers *all, const uint8_t *status, int count)
{
    uint32_t hits = 0, sum = 0;
    for (int i = 0; i < count; i++) {
        hits += status[i] == SURE_HIT;
        sum += status[i];
    }
    all->hits += hits;
    all->sum += sum;
}

/* For what the naive routine answers, too: the part where there are several. */
static answers ask_blocks(const bench_turn *turn, int subject)
{
    const bool floats = turn->plan->floats;
    const size_t size = floats ? sizeof(float) : sizeof(double);
    _Alignas(64) uint8_t status[BENCH_BLOCK_MOST], part[BENCH_BLOCK_MOST];
    _Alignas(64) double t[BENCH_BLOCK_MOST];
    _Alignas(64) float t_f[BENCH_BLOCK_MOST];
    answers all = {0, 0};
    const bool several = sure_shape_info_of(turn->shape)->part_count > 1;
    for (int from = 0; from < turn->count; from += turn->plan->block) {
        const int left = turn->count - from;
        const int count = left < turn->plan->block ? left : turn->plan->block;
        sure_rays rays;
        sure_objects objects;
        asked_from(turn, size, from, &rays, &objects);
        const sure_hits hits = {.status = {status, 1},
                                .part = {several ? part : NULL, 1},
                                .t = {floats ? (void *)t_f : (void *)t, (ptrdiff_t)size}};
        if (floats)
            sure_objects_hits_certain_f((size_t)count, &rays, &objects, &hits);
        else if (subject == BENCH_NAIVE_BLOCK)
            ask_naive_block(turn, from, count, status, part, t);
        else
            sure_objects_hits((size_t)count, &rays, &objects, (sure_tier)(subject - BENCH_TIER(0)),
                              &hits);
        for (int i = 0; i < count; i++)
            all.sum += bench_t_sum((sure_status)status[i], floats ? (double)t_f[i] : t[i]);
        add_statuses(&all, status, count);
    }
    return all;
}

answers bench_ask(const bench_turn *turn, int subject)
{
#define ASKER(shape, SHAPE) ask_##shape,
#define ASKER_F(shape, SHAPE) ask_##shape##_f,
    static answers (*const askers[])(int, const sure_case *, int) = {SURE_EACH_SHAPE(ASKER)};
    static answers (*const askers_f[])(int, const float_query *, int) = {SURE_EACH_SHAPE(ASKER_F)};
    if (turn->plan->block > 0 && subject != BENCH_NAIVE)
        return ask_blocks(turn, subject);
    if (turn->plan->floats)
        return askers_f[turn->shape](subject, turn->floats, turn->count);
    return askers[turn->shape](subject, turn->cases, turn->count);
}
