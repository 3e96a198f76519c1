/* SPDX-License-Identifier: MIT */
/* The first stage of `certain` for many queries of a shape, LANES side by side. Compiled once for
 * each width; what a query is answered here, it is answered alone. */
#include "../../stages/hits/block.h"

#include "lanes.h"

#include "answer.h"

#include "../box/box_lanes.h"
#include "../cone/cone_lanes.h"
#include "../cylinder/cylinder_lanes.h"
#include "../disc/disc_lanes.h"
#include "../plane/plane_lanes.h"
#include "../sphere/sphere_lanes.h"

static inline double number_at(const void *column, size_t i)
{
    return lanes_at((const char *)column + i * LANES_STRIDE);
}

static inline lanes_floats floats_at(const void *column, size_t i)
{
    return lanes_floats_at((const char *)column + i * sizeof(float));
}

static inline double number_at_f(const void *column, size_t i)
{
    return lanes_of_floats(floats_at(column, i));
}

static inline double number_of_all(const void *column)
{
    return lanes_all_at(column);
}

static inline double number_of_all_f(const void *column)
{
    return lanes_all_of_float(column);
}

static inline void put_bytes_where(lanes_bytes met, uint8_t *column, size_t i, lanes_bytes x)
{
    lanes_bytes_to(column + i, (x & met) | (lanes_bytes_at(column + i) & ~met));
}

static inline void put_number_where(bool met, void *column, size_t i, double x)
{
    lanes_to((char *)column + i * LANES_STRIDE, lanes_where(met, x, number_at(column, i)));
}

/* What both have. */
static inline void put_decision(const block *b, size_t i, bool certain, bool hit,
                                const lanes_answer *said)
{
    const lanes_bytes hits = lanes_bytes_of_mask(hit);
    const lanes_bytes uncertain = (lanes_bytes)~lanes_bytes_of_mask(certain);
    lanes_bytes_to(b->status + i, (hits & LANES_BYTES(SURE_HIT)) |
                                      (~(hits | uncertain) & LANES_BYTES(SURE_MISS)) |
                                      (uncertain & LANES_BYTES(BLOCK_UNCERTAIN)));
    if (b->part)
        put_bytes_where(hits, b->part, i, lanes_bytes_of(said->part));
    if (b->leaves)
        put_bytes_where(hits, b->leaves, i, lanes_bytes_of_mask(said->leaves) & LANES_BYTES(1));
}

static inline void put_answer(const block *b, size_t i, const lanes_answer *said)
{
    put_decision(b, i, said->certain, said->hits, said);
    if (b->t)
        put_number_where(said->hits, b->t, i, said->t);
    if (b->t_error)
        put_number_where(said->hits, b->t_error, i, said->error);
}

/* floats_round (stages/floats.h). */
static inline void put_answer_f(const block *b, size_t i, const lanes_answer *said)
{
    double off = filter_float_off(said->t, said->error);
    lanes_floats low = lanes_floats_of(said->t - off), high = lanes_floats_of(said->t + off);
    bool rounds = lanes_same_floats(low, high), hits = said->hits & rounds;
    put_decision(b, i, said->certain & (rounds | (true ^ said->hits)), hits, said);
    if (b->t)
        lanes_floats_to((char *)b->t + i * sizeof(float),
                        lanes_floats_where(hits, low, floats_at(b->t, i)));
}

/* 0xff where a status is BLOCK_UNCERTAIN: of these alone the highest bit is set. */
static inline lanes_bytes uncertain_in(lanes_bytes status)
{
    return (lanes_bytes)((status >> 7 & LANES_BYTES(1)) * 0xff);
}

#ifdef __GNUC__
#define IN_REGISTERS _Pragma("GCC unroll 8")
#else
#define IN_REGISTERS
#endif

/* How far behind the first queries the second ones begin: all others stand beside each other, and
 * the last ones end with the block. */
static inline size_t first_step(const block *b)
{
    const size_t rest = b->count % LANES;
    return rest > 0 ? rest : LANES;
}

/* What is needed of one object alone is computed once for all rays before it. */
#ifdef __GNUC__
#define LANES_WHOLE __attribute__((flatten))
#define LANES_APART __attribute__((noinline))
#else
#define LANES_WHOLE
#define LANES_APART
#endif

/* After so many groups that all miss, the next ones are asked whether they do, too. Where that is
 * not told of one, it is asked again later, and later each time. What is mixed hardly ever comes so
 * far. */
enum { RUN = 16 };

/* Are runs looked at where <shape>_lanes_miss tells a certain miss long before any end is computed
 * (<shape>_tells_misses)? Of doubles alone, since of floats it would be as much code again, and of
 * more than two. */
enum { RUNS = LANES > 2, RUNS_f = 0 };

#define ALL_MISS LANES_BYTES(SURE_MISS)

/* No branch, since it is as good as random. */
static inline size_t run_after(size_t run, lanes_bytes status)
{
    return (run + 1) & (size_t)bits_unknown(-(size_t)(status == ALL_MISS));
}

/* Of columns of doubles, and `_f` of floats. */
#define RAY_AT(of)                                                                                 \
    static inline sure_ray ray_at##of(const block *b, size_t i)                                    \
    {                                                                                              \
        const void *const *column = b->ray;                                                        \
        return (sure_ray){                                                                         \
            {number_at##of(column[0], i), number_at##of(column[1], i),                             \
             number_at##of(column[2], i)},                                                         \
            {number_at##of(column[3], i), number_at##of(column[4], i),                             \
             number_at##of(column[5], i)},                                                         \
            number_at##of(column[6], i),                                                           \
            number_at##of(column[7], i),                                                           \
        };                                                                                         \
    }
RAY_AT()
RAY_AT(_f)

/* Groups, by their first queries, that are begun and wait for what takes long: the last two. */
typedef struct {
    size_t first, second, begun; /* begun: how many ever were */
} waiting;

#define NO_GROUP SIZE_MAX

/* Which one ends when another is begun? */
static inline size_t waiting_next(waiting *all, size_t group)
{
    const size_t ends = all->begun < 2 ? NO_GROUP : all->first;
    *all = (waiting){all->second, group, all->begun + 1};
    return ends;
}

#define STAGE_OF(shape, of)                                                                        \
    static inline sure_##shape shape##_at##of(const block *b, size_t i)                            \
    {                                                                                              \
        sure_##shape object;                                                                       \
        double *to = (double *)(void *)&object;                                                    \
        IN_REGISTERS                                                                               \
        for (size_t k = 0; k < sizeof object / sizeof *to; k++)                                    \
            to[k] = number_at##of(b->object[k], i);                                                \
        return object;                                                                             \
    }                                                                                              \
    static inline sure_##shape shape##_of_all##of(const block *b)                                  \
    {                                                                                              \
        sure_##shape object;                                                                       \
        double *to = (double *)(void *)&object;                                                    \
        IN_REGISTERS                                                                               \
        for (size_t k = 0; k < sizeof object / sizeof *to; k++)                                    \
            to[k] = number_of_all##of(b->object[k]);                                               \
        return object;                                                                             \
    }                                                                                              \
    static inline shape##_begun shape##_begin_at##of(const block *b, size_t i,                     \
                                                     const sure_##shape *object)                   \
    {                                                                                              \
        const sure_ray ray = ray_at##of(b, i);                                                     \
        return shape##_begin(&ray, object);                                                        \
    }                                                                                              \
    static inline void shape##_end_at##of(const block *b, size_t i, const shape##_begun *begun)    \
    {                                                                                              \
        const sure_ray ray = ray_at##of(b, i);                                                     \
        const lanes_answer said = shape##_end(&ray, begun);                                        \
        put_answer##of(b, i, &said);                                                               \
    }                                                                                              \
    static inline void shape##_ask##of(const block *b, size_t i, const sure_##shape *object)       \
    {                                                                                              \
        const shape##_begun begun = shape##_begin_at##of(b, i, object);                            \
        shape##_end_at##of(b, i, &begun);                                                          \
    }                                                                                              \
    typedef struct {                                                                               \
        waiting groups;                                                                            \
        shape##_begun first, second;                                                               \
    } shape##_waiting##of;                                                                         \
    /* The group that ends, with another one begun. */                                             \
    static inline size_t shape##_end_next##of(const block *b, shape##_waiting##of *all,            \
                                              size_t group, const shape##_begun *begun)            \
    {                                                                                              \
        const size_t ends = waiting_next(&all->groups, group);                                     \
        if (ends != NO_GROUP)                                                                      \
            shape##_end_at##of(b, ends, &all->first);                                              \
        all->first = all->second;                                                                  \
        all->second = *begun;                                                                      \
        return ends;                                                                               \
    }                                                                                              \
    static inline size_t shape##_ask_next##of(                                                     \
        const block *b, size_t i, const sure_##shape *object, shape##_waiting##of *all)            \
    {                                                                                              \
        const shape##_begun begun = shape##_begin_at##of(b, i, object);                            \
        if (shape##_ends_later)                                                                    \
            return shape##_end_next##of(b, all, i, &begun);                                        \
        shape##_end_at##of(b, i, &begun);                                                          \
        return i;                                                                                  \
    }                                                                                              \
    /* Groups from i on that all miss, as is told long before any end is: up to which? */          \
    LANES_APART static size_t shape##_pass##of(const block *b, size_t i)                           \
    {                                                                                              \
        const sure_##shape object = shape##_of_all##of(b);                                         \
        for (; i < b->count; i += LANES) {                                                         \
            const sure_ray ray = ray_at##of(b, i);                                                 \
            if (lanes_bytes_of_mask(shape##_lanes_miss(&ray, &object)) != LANES_BYTES(0xff))       \
                break;                                                                             \
            lanes_bytes_to(b->status + i, ALL_MISS);                                               \
        }                                                                                          \
        return i;                                                                                  \
    }                                                                                              \
    LANES_APART static void shape##_ask_other##of(const block *b, size_t i)                        \
    {                                                                                              \
        const sure_##shape object = shape##_at##of(b, i);                                          \
        shape##_ask##of(b, i, &object);                                                            \
    }                                                                                              \
    /* From group i on, until so many in a row have missed: up to which? */                        \
    static inline size_t shape##_ask_from##of(const block *b, size_t i, size_t run)                \
    {                                                                                              \
        const sure_##shape object = shape##_of_all##of(b);                                         \
        const _Bool runs = shape##_tells_misses && RUNS##of;                                       \
        const size_t count = b->count;                                                             \
        size_t step = i == 0 ? first_step(b) : LANES;                                              \
        shape##_waiting##of all = {.groups = {.begun = 0}};                                        \
        for (; i < count && (!runs || run < RUN); i += step, step = LANES) {                       \
            const size_t ended = shape##_ask_next##of(b, i, &object, &all);                        \
            if (runs && ended != NO_GROUP)                                                         \
                run = run_after(run, lanes_bytes_at(b->status + ended));                           \
        }                                                                                          \
        for (int left = shape##_ends_later ? 2 : 0; left > 0; left--)                              \
            (void)shape##_end_next##of(b, &all, NO_GROUP, &all.second);                            \
        return i;                                                                                  \
    }                                                                                              \
    LANES_WHOLE static void shape##_stage##of(const block *b)                                      \
    {                                                                                              \
        size_t step = first_step(b), apart = RUN, i = 0;                                           \
        while (b->one_object && i < b->count) {                                                    \
            i = shape##_ask_from##of(b, i, RUN - apart);                                           \
            if (!(shape##_tells_misses && RUNS##of))                                               \
                break;                                                                             \
            const size_t end = shape##_pass##of(b, i);                                             \
            apart = end > i ? 1 : apart < RUN ? apart + 1 : RUN;                                   \
            i = end;                                                                               \
        }                                                                                          \
        for (; !b->one_object && i < b->count; i += step, step = LANES)                            \
            shape##_ask_other##of(b, i);                                                           \
    }                                                                                              \
    LANES_WHOLE static void shape##_closely##of(const block *b)                                    \
    {                                                                                              \
        size_t step = first_step(b);                                                               \
        for (size_t i = 0; i < b->count; i += step, step = LANES) {                                \
            const lanes_bytes left = uncertain_in(lanes_bytes_at(b->status + i));                  \
            if (left == 0)                                                                         \
                continue;                                                                          \
            const sure_##shape object =                                                            \
                b->one_object ? shape##_of_all##of(b) : shape##_at##of(b, i);                      \
            const sure_ray ray = ray_at##of(b, i);                                                 \
            lanes_answer said = shape##_lanes_closely(&ray, &object);                              \
            const lanes_bytes told = lanes_bytes_at(b->status + i);                                \
            put_answer##of(b, i, &said);                                                           \
            put_bytes_where((lanes_bytes)~left, b->status, i, told);                               \
        }                                                                                          \
    }
#define STAGE(shape, SHAPE) STAGE_OF(shape, ) STAGE_OF(shape, _f)
SURE_EACH_SHAPE(STAGE)

#define STAGES_NAME(width, of) block_stages_##width##of
#define STAGES_OF(width, of) STAGES_NAME(width, of)
#define ROW_OF(shape, of) {shape##_stage##of, shape##_looks_closely ? shape##_closely##of : NULL},
#define ROW(shape, SHAPE) ROW_OF(shape, )
#define ROW_F(shape, SHAPE) ROW_OF(shape, _f)
const block_stage STAGES_OF(LANES, )[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
const block_stage STAGES_OF(LANES, _f)[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW_F)};
