/* SPDX-License-Identifier: MIT */
#include "block.h"

#include <surehit/many.h>

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static inline double number_of(const sure_numbers *column, size_t i)
{
    double number;
    assert(column->first);
    memcpy(&number, (const char *)column->first + (ptrdiff_t)i * column->stride, sizeof number);
    return number;
}

static inline void put_number(const sure_number_column *column, size_t i, double number)
{
    if (column->first)
        memcpy((char *)column->first + (ptrdiff_t)i * column->stride, &number, sizeof number);
}

static inline void put_byte(const sure_byte_column *column, size_t i, int byte)
{
    if (column->first)
        column->first[(ptrdiff_t)i * column->stride] = (uint8_t)byte;
}

static void columns_of(const char *first, ptrdiff_t stride, int count, sure_numbers *columns)
{
    for (int k = 0; k < count; k++)
        columns[k] = (sure_numbers){first + k * (int)sizeof(double), stride};
}

_Static_assert(sizeof(sure_ray) == RAY_NUMBERS * sizeof(double), "a ray's numbers");
_Static_assert(sizeof(sure_rays) == RAY_NUMBERS * sizeof(sure_numbers), "a column a number");
_Static_assert(OBJECT_NUMBERS == SURE_SHAPE_NUMBERS, "the most that an object has");

sure_rays sure_rays_of(const void *first, ptrdiff_t stride)
{
    sure_rays rays;
    columns_of(first, stride, RAY_NUMBERS, rays.origin);
    return rays;
}

sure_objects sure_objects_of(sure_shape shape, const void *first, ptrdiff_t stride)
{
    sure_objects objects = {.shape = shape};
    columns_of(first, stride, sure_shape_info_of(shape)->numbers, objects.numbers);
    return objects;
}

static inline void gather_ray(const sure_rays *rays, size_t i, sure_ray *ray)
{
    const sure_numbers *o = rays->origin, *d = rays->direction;
    *ray = (sure_ray){
        .origin = {number_of(&o[0], i), number_of(&o[1], i), number_of(&o[2], i)},
        .direction = {number_of(&d[0], i), number_of(&d[1], i), number_of(&d[2], i)},
        .t_min = number_of(&rays->t_min, i),
        .t_max = number_of(&rays->t_max, i),
    };
}

static inline void gather_object(const sure_objects *objects, int numbers, size_t i,
                                 sure_object *object)
{
    double *to = (double *)(void *)&object->as;
    for (int k = 0; k < numbers; k++)
        to[k] = number_of(&objects->numbers[k], i);
}

static inline bool wants_normals(const sure_hits *hits)
{
    return hits->normal[0].first || hits->normal[1].first || hits->normal[2].first;
}

static void put_normal(const sure_ray *ray, const sure_object *object, sure_tier tier,
                       const sure_hit *hit, const sure_hits *hits, size_t i)
{
    sure_vec3 normal = sure_object_normal(ray, object, tier, hit);
    put_number(&hits->normal[0], i, normal.x);
    put_number(&hits->normal[1], i, normal.y);
    put_number(&hits->normal[2], i, normal.z);
}

static inline void put_answer(const sure_ray *ray, const sure_object *object, sure_tier tier,
                              const sure_hits *hits, size_t i)
{
    sure_hit hit;
    sure_status status = sure_object_hit(ray, object, tier, &hit);
    put_byte(&hits->status, i, (int)status);
    if (status != SURE_HIT)
        return;
    put_byte(&hits->part, i, (int)hit.part);
    put_byte(&hits->leaves, i, hit.leaves);
    put_number(&hits->t, i, hit.t);
    put_number(&hits->t_error, i, hit.t_error);
    if (wants_normals(hits))
        put_normal(ray, object, tier, &hit, hits, i);
}

/* Columns that don't stand as a block wants them. */
typedef struct {
    double ray[RAY_NUMBERS][BLOCK], object[OBJECT_NUMBERS][BLOCK], t[BLOCK], t_error[BLOCK];
    uint8_t status[BLOCK], part[BLOCK], leaves[BLOCK];
} block_room;

/* A column from query `from` on, gathered if it must be. One number for all is gathered once. */
static const void *column_in(const sure_numbers *column, size_t from, size_t count, double *room)
{
    const ptrdiff_t stride = column->stride;
    const char *at = (const char *)column->first + (ptrdiff_t)from * stride;
    assert(column->first);
    if (stride == sizeof *room && count == BLOCK)
        return at;
    if (stride == 0 && from != 0)
        return room;
    for (size_t i = 0; i < count; i++, at += stride)
        memcpy(&room[i], at, sizeof *room);
    for (size_t i = count; i < BLOCK; i++)
        room[i] = room[0];
    return room;
}

static void *number_column_in(const sure_number_column *column, size_t from, size_t count,
                              double *room)
{
    bool stands = column->first && column->stride == sizeof *room && count == BLOCK;
    return stands ? (char *)column->first + from * sizeof *room : (void *)room;
}

static uint8_t *byte_column_in(const sure_byte_column *column, size_t from, size_t count,
                               uint8_t *room)
{
    return column->first && column->stride == 1 && count == BLOCK ? column->first + from : room;
}

/* What was answered in the room goes to where it is wanted. */
static void numbers_out(const sure_number_column *column, size_t from, size_t count,
                        const void *answers, const uint8_t *status)
{
    double answer, number;
    char *to = (char *)column->first + (ptrdiff_t)from * column->stride;
    if (!column->first || answers == to)
        return;
    for (size_t i = 0; i < count; i++, to += column->stride) {
        memcpy(&answer, (const char *)answers + i * sizeof answer, sizeof answer);
        memcpy(&number, to, sizeof number);
        number = status[i] == SURE_HIT ? answer : number;
        memcpy(to, &number, sizeof number);
    }
}

static void bytes_out(const sure_byte_column *column, size_t from, size_t count,
                      const uint8_t *answers, const uint8_t *status)
{
    uint8_t *to = column->first + (ptrdiff_t)from * column->stride;
    if (!column->first || answers == to)
        return;
    for (size_t i = 0; i < count; i++, to += column->stride)
        *to = !status || status[i] == SURE_HIT ? answers[i] : *to;
}

/* The queries that the first stage leaves, and normals where they are wanted. */
static void rest_of_block(const block *b, size_t from, const sure_rays *rays,
                          const sure_objects *objects, const sure_hits *hits)
{
    sure_ray ray;
    sure_object object = {.shape = objects->shape};
    const int numbers = sure_shape_info_of(objects->shape)->numbers;
    const bool normals = wants_normals(hits);
    if (!normals && !memchr(b->status, BLOCK_UNCERTAIN, b->count))
        return;
    for (size_t i = 0; i < b->count; i++) {
        const bool uncertain = b->status[i] == BLOCK_UNCERTAIN;
        if (!uncertain && !(normals && b->status[i] == SURE_HIT))
            continue;
        gather_ray(rays, from + i, &ray);
        gather_object(objects, numbers, from + i, &object);
        if (uncertain) {
            put_answer(&ray, &object, SURE_TIER_CERTAIN, hits, from + i);
            continue;
        }
        sure_hit hit = {.part = (sure_part)b->part[i], .leaves = b->leaves[i]};
        memcpy(&hit.t, (const char *)b->t + i * sizeof hit.t, sizeof hit.t);
        memcpy(&hit.t_error, (const char *)b->t_error + i * sizeof hit.t, sizeof hit.t);
        put_normal(&ray, &object, SURE_TIER_CERTAIN, &hit, hits, from + i);
    }
}

/* `count` queries from `from` on. */
static void block_hits(block_stage *stage, block_room *room, size_t from, size_t count,
                       const sure_rays *rays, const sure_objects *objects, bool one_object,
                       const sure_hits *hits)
{
    const int numbers = sure_shape_info_of(objects->shape)->numbers;
    const sure_numbers *ray = rays->origin; /* and the others behind it */
    block b = {.count = count,
               .one_object = one_object,
               .status = byte_column_in(&hits->status, from, count, room->status),
               .part = byte_column_in(&hits->part, from, count, room->part),
               .leaves = byte_column_in(&hits->leaves, from, count, room->leaves),
               .t = number_column_in(&hits->t, from, count, room->t),
               .t_error = number_column_in(&hits->t_error, from, count, room->t_error)};
    for (int k = 0; k < RAY_NUMBERS; k++)
        b.ray[k] = column_in(&ray[k], from, count, room->ray[k]);
    for (int k = 0; k < numbers; k++)
        b.object[k] = column_in(&objects->numbers[k], from, count, room->object[k]);
    stage(&b);
    numbers_out(&hits->t, from, count, b.t, b.status);
    numbers_out(&hits->t_error, from, count, b.t_error, b.status);
    bytes_out(&hits->part, from, count, b.part, b.status);
    bytes_out(&hits->leaves, from, count, b.leaves, b.status);
    bytes_out(&hits->status, from, count, b.status, NULL);
    rest_of_block(&b, from, rays, objects, hits);
}

/* How many of them block_hits answers; too few are not worth it. */
static size_t blocks_hits(size_t count, const sure_rays *rays, const sure_objects *objects,
                          const sure_hits *hits)
{
    block_stage *const *stages = block_stages();
    block_room room;
    bool one_object = true;
    size_t done = 0;
    for (int k = 0; k < sure_shape_info_of(objects->shape)->numbers; k++)
        one_object = one_object && objects->numbers[k].stride == 0;
    for (size_t left = count; stages && left >= BLOCK_LEAST; left = count - done) {
        const size_t now = left < BLOCK ? left : BLOCK;
        block_hits(stages[objects->shape], &room, done, now, rays, objects, one_object, hits);
        done += now;
    }
    return done;
}

static void hits_one_by_one(size_t from, size_t to, const sure_rays *rays,
                            const sure_objects *objects, sure_tier tier, const sure_hits *hits)
{
    sure_ray ray;
    sure_object object = {.shape = objects->shape};
    const int numbers = sure_shape_info_of(objects->shape)->numbers;
    for (size_t i = from; i < to; i++) {
        gather_ray(rays, i, &ray);
        gather_object(objects, numbers, i, &object);
        put_answer(&ray, &object, tier, hits, i);
    }
}

void sure_objects_hits(size_t count, const sure_rays *rays, const sure_objects *objects,
                       sure_tier tier, const sure_hits *hits)
{
    assert(hits->status.first || count == 0);
    size_t done = tier == SURE_TIER_CERTAIN ? blocks_hits(count, rays, objects, hits) : 0;
    hits_one_by_one(done, count, rays, objects, tier, hits);
}

#define HITS(name, NAME, tier_name, TIER)                                                          \
    void sure_##name##_hits_##tier_name(size_t count, const sure_rays *rays,                       \
                                        const sure_##name *name, const sure_hits *hits)            \
    {                                                                                              \
        const sure_objects objects = sure_objects_of(SURE_SHAPE_##NAME, name, 0);                  \
        sure_objects_hits(count, rays, &objects, SURE_TIER_##TIER, hits);                          \
    }
#define HITS_OF_SHAPE(shape, SHAPE)                                                                \
    HITS(shape, SHAPE, float32, FLOAT32)                                                           \
    HITS(shape, SHAPE, textbook, TEXTBOOK)                                                         \
    HITS(shape, SHAPE, stable, STABLE)                                                             \
    HITS(shape, SHAPE, certain, CERTAIN)                                                           \
    HITS(shape, SHAPE, exact, EXACT)
SURE_EACH_SHAPE(HITS_OF_SHAPE)
