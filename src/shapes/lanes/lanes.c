/* SPDX-License-Identifier: MIT */
/* The first stage of `certain` for many queries of a shape, LANES side by side. Compiled once for
 * each width; what a query is answered here, it is answered alone. */
#include "../../stages/hits/block.h"

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

static inline sure_ray ray_at(const block *b, size_t i)
{
    const void *const *column = b->ray;
    return (sure_ray){
        {number_at(column[0], i), number_at(column[1], i), number_at(column[2], i)},
        {number_at(column[3], i), number_at(column[4], i), number_at(column[5], i)},
        number_at(column[6], i),
        number_at(column[7], i),
    };
}

static inline void put_bytes_where(bool met, uint8_t *column, size_t i, uint64_t x)
{
    lanes_bytes_to(column + i, lanes_where_bits(met, x, lanes_bytes_at(column + i)));
}

static inline void put_number_where(bool met, void *column, size_t i, double x)
{
    lanes_to((char *)column + i * LANES_STRIDE, lanes_where(met, x, number_at(column, i)));
}

static inline void put_answer(const block *b, size_t i, const lanes_answer *said)
{
    uint64_t hits = (uint64_t)said->hits, misses = (uint64_t)said->misses;
    lanes_bytes_to(b->status + i,
                   (hits & SURE_HIT) | (misses & SURE_MISS) | (~(hits | misses) & BLOCK_UNCERTAIN));
    put_bytes_where(said->hits, b->part, i, said->part);
    put_bytes_where(said->hits, b->leaves, i, (uint64_t)said->leaves & 1);
    put_number_where(said->hits, b->t, i, said->t);
    put_number_where(said->hits, b->t_error, i, said->error);
}

#define STAGE(shape, SHAPE)                                                                        \
    static inline sure_##shape shape##_at(const block *b, size_t i)                                \
    {                                                                                              \
        sure_##shape object;                                                                       \
        double *to = (double *)(void *)&object;                                                    \
        for (size_t k = 0; k < sizeof object / sizeof *to; k++)                                    \
            to[k] = number_at(b->object[k], i);                                                    \
        return object;                                                                             \
    }                                                                                              \
    static void shape##_stage(const block *b)                                                      \
    {                                                                                              \
        for (size_t i = 0; i < b->count; i += LANES) {                                             \
            const sure_ray ray = ray_at(b, i);                                                     \
            const sure_##shape object = shape##_at(b, b->one_object ? 0 : i);                      \
            const lanes_answer said = shape##_lanes(&ray, &object);                                \
            put_answer(b, i, &said);                                                               \
        }                                                                                          \
    }
SURE_EACH_SHAPE(STAGE)

#define STAGES_NAME(width) block_stages_##width
#define STAGES_OF(width) STAGES_NAME(width)
#define ROW(shape, SHAPE) shape##_stage,
block_stage *const STAGES_OF(LANES)[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
