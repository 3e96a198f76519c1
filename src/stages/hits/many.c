/* SPDX-License-Identifier: MIT */
/* Columns are of doubles or of floats: `size` bytes a number, which is known where it matters. */
#include "../floats.h"
#include "columns.h"

#include <assert.h>
#include <string.h>

/* What is asked and where the answers go. `floats`: for certain_f, and `tier` is certain.
 * `object`: the one that all doubles ask; NULL for others. */
typedef struct {
    const sure_rays *rays;
    const sure_objects *objects;
    const sure_hits *hits;
    sure_tier tier;
    bool floats;
    const sure_object *object;
} many;

static INLINED void gather(const sure_numbers *columns, size_t count, size_t i, size_t size,
                           void *to)
{
    FLOATS_ONE_BY_ONE
    for (size_t k = 0; k < count; k++) {
        const sure_numbers *column = &columns[k];
        assert(column->first);
        memcpy((char *)to + k * size, (const char *)column->first + (ptrdiff_t)i * column->stride,
               size);
    }
}

static inline void put_number(const sure_number_column *column, size_t i, const void *number,
                              size_t size)
{
    if (column->first)
        memcpy((char *)column->first + (ptrdiff_t)i * column->stride, number, size);
}

static inline void put_byte(const sure_byte_column *column, size_t i, int byte)
{
    if (column->first)
        column->first[(ptrdiff_t)i * column->stride] = (uint8_t)byte;
}

static void columns_of(const char *first, ptrdiff_t stride, size_t size, int count,
                       sure_numbers *columns)
{
    for (int k = 0; k < count; k++)
        columns[k] = (sure_numbers){first + (size_t)k * size, stride};
}

_Static_assert(sizeof(sure_ray) == RAY_NUMBERS * sizeof(double), "a ray's numbers");
_Static_assert(sizeof(sure_ray_f) == RAY_NUMBERS * sizeof(float), "likewise");
_Static_assert(sizeof(sure_rays) == RAY_NUMBERS * sizeof(sure_numbers), "a column a number");
_Static_assert(OBJECT_NUMBERS == SURE_SHAPE_NUMBERS, "the most that an object has");

static int numbers_of(sure_shape shape)
{
    return sure_shape_info_of(shape)->numbers;
}

#define COLUMNS(suffix, number)                                                                    \
    sure_rays sure_rays_of##suffix(const void *first, ptrdiff_t stride)                            \
    {                                                                                              \
        sure_rays rays;                                                                            \
        columns_of(first, stride, sizeof(number), RAY_NUMBERS, (void *)&rays);                     \
        return rays;                                                                               \
    }                                                                                              \
    sure_objects sure_objects_of##suffix(sure_shape shape, const void *first, ptrdiff_t stride)    \
    {                                                                                              \
        sure_objects objects = {.shape = shape};                                                   \
        columns_of(first, stride, sizeof(number), numbers_of(shape), objects.numbers);             \
        return objects;                                                                            \
    }
COLUMNS(, double)
COLUMNS(_f, float)

static inline void gather_object(const many *m, size_t i, size_t size, void *object)
{
    gather(m->objects->numbers, (size_t)numbers_of(m->objects->shape), i, size, object);
}

static inline bool wants_normals(const sure_hits *hits)
{
    return hits->normal[0].first || hits->normal[1].first || hits->normal[2].first;
}

/* normal: three numbers. */
static inline void put_normal(const sure_hits *hits, size_t i, const void *normal, size_t size)
{
    for (size_t k = 0; k < 3; k++)
        put_number(&hits->normal[k], i, (const char *)normal + k * size, size);
}

static inline void put_answer(const sure_hits *hits, size_t i, sure_status status, const void *t,
                              size_t size, sure_part part, int leaves)
{
    put_byte(&hits->status, i, (int)status);
    if (status != SURE_HIT)
        return;
    put_byte(&hits->part, i, (int)part);
    put_byte(&hits->leaves, i, leaves);
    put_number(&hits->t, i, t, size);
}

/* Query i alone. */
static INLINED void answer_of(const many *m, size_t i, const sure_ray *ray,
                              const sure_object *object)
{
    sure_hit hit = {.t = 0};
    sure_status status = sure_object_hit(ray, object, m->tier, &hit);
    put_answer(m->hits, i, status, &hit.t, sizeof hit.t, hit.part, hit.leaves);
    if (status != SURE_HIT)
        return;
    put_number(&m->hits->t_error, i, &hit.t_error, sizeof hit.t_error);
    if (!wants_normals(m->hits))
        return;
    const sure_vec3 normal = sure_object_normal(ray, object, m->tier, &hit);
    put_normal(m->hits, i, &normal, sizeof(double));
}

static void answer_floats(const many *m, size_t i)
{
    const sure_shape shape = m->objects->shape;
    sure_ray_f ray;
    float object[OBJECT_NUMBERS];
    sure_hit_f hit = {.t = 0};
    gather((const void *)m->rays, RAY_NUMBERS, i, sizeof(float), &ray);
    gather_object(m, i, sizeof(float), object);
    sure_status status = floats_rest_of_hit(&ray, object, &hit, shape);
    put_answer(m->hits, i, status, &hit.t, sizeof hit.t, hit.part, hit.leaves);
    if (status != SURE_HIT || !wants_normals(m->hits))
        return;
    const sure_float_vec3 normal = floats_normal(&ray, object, &hit, shape, m->tier);
    put_normal(m->hits, i, &normal, sizeof(float));
}

static void answer_alone(const many *m, size_t i)
{
    sure_ray ray;
    sure_object object = {.shape = m->objects->shape};
    if (m->floats) {
        answer_floats(m, i);
        return;
    }
    gather((const void *)m->rays, RAY_NUMBERS, i, sizeof(double), &ray);
    if (!m->object)
        gather_object(m, i, sizeof(double), &object.as);
    answer_of(m, i, &ray, m->object ? m->object : &object);
}

/* Query i of doubles, as it stands in the block; its object may stand in the room. */
static INLINED const sure_object *query_in(const many *m, const block *b, size_t i, sure_ray *ray,
                                           sure_object *room)
{
    double *to = (double *)(void *)ray, *of = (double *)(void *)&room->as;
    FLOATS_ONE_BY_ONE
    for (size_t k = 0; k < RAY_NUMBERS; k++)
        memcpy(&to[k], number_in(b->ray[k], i), sizeof *to);
    if (m->object)
        return m->object;
    room->shape = m->objects->shape;
    for (int k = 0; k < numbers_of(m->objects->shape); k++)
        memcpy(&of[k], number_in(b->object[k], i), sizeof *of);
    return room;
}

/* What is left of it, or the normal of its hit; floats' finds t anew. */
static void rest_of_query(const many *m, const block *b, size_t from, size_t i, bool left)
{
    sure_ray ray;
    sure_object room;
    if (m->floats) {
        answer_floats(m, from + i);
        return;
    }
    const sure_object *object = query_in(m, b, i, &ray, &room);
    if (left) {
        answer_of(m, from + i, &ray, object);
        return;
    }
    sure_hit hit = {.part = (sure_part)b->part[i], .leaves = b->leaves[i]};
    memcpy(&hit.t, number_in(b->t, i), sizeof hit.t);
    memcpy(&hit.t_error, number_in(b->t_error, i), sizeof hit.t_error);
    const sure_vec3 normal = sure_object_normal(&ray, object, m->tier, &hit);
    put_normal(m->hits, from + i, &normal, sizeof(double));
}

/* The queries that the first stage leaves, and normals where they are wanted. Where one is left
 * others are near it. */
static void rest_of_block(const many *m, const block *b, size_t from)
{
    const bool normals = wants_normals(m->hits);
    for (size_t i = 0; i < b->count; i++) {
        const uint8_t *at = b->status + i;
        if (!normals && i % BLOCK == 0 && !(at = memchr(at, BLOCK_UNCERTAIN, b->count - i)))
            return;
        i = (size_t)(at - b->status);
        const bool left = *at == BLOCK_UNCERTAIN;
        if (left || (normals && *at == SURE_HIT))
            rest_of_query(m, b, from, i, left);
    }
}

static INLINED void ask_lanes(const block_stage *stage, const block *b)
{
    stage->first(b);
    if (stage->closely && memchr(b->status, BLOCK_UNCERTAIN, b->count))
        stage->closely(b);
}

/* A first stage of doubles holds where subnormals are flushed, too (docs/proofs). Not one of
 * floats: a subnormal float would be read as zero. */
static INLINED void ask(const block_stage *stage, const block *b, size_t size)
{
    environment given;
    if (size != sizeof(double)) {
        ask_lanes(stage, b);
        return;
    }
    environment_flush(&given);
    ask_lanes(stage, b);
    environment_leave(&given);
}

/* `count` queries from `from` on. */
static INLINED void block_hits(const many *m, const block_stage *stage, block_room *room,
                               size_t from, size_t count, size_t size, bool one_object)
{
    const int numbers = numbers_of(m->objects->shape);
    const sure_numbers *ray = (const void *)m->rays;
    const sure_hits *hits = m->hits;
    const bool all = wants_normals(hits); /* which are found with all others */
    block b = {.count = count,
               .one_object = one_object,
               .status = byte_column_in(&hits->status, from, count, room->status, true),
               .part = byte_column_in(&hits->part, from, count, room->part, all),
               .leaves = byte_column_in(&hits->leaves, from, count, room->leaves, all),
               .t = number_column_in(&hits->t, from, count, size, room->t, all),
               .t_error = number_column_in(&hits->t_error, from, count, size, room->t_error, all)};
    for (int k = 0; k < RAY_NUMBERS; k++)
        b.ray[k] = column_in(&ray[k], from, count, size, room->ray[k]);
    for (int k = 0; k < numbers; k++)
        b.object[k] = one_object
                          ? m->objects->numbers[k].first
                          : column_in(&m->objects->numbers[k], from, count, size, room->object[k]);
    ask(stage, &b, size);
    numbers_out(&hits->t, from, count, size, b.t, b.status);
    numbers_out(&hits->t_error, from, count, size, b.t_error, b.status);
    bytes_out(&hits->part, from, count, b.part, b.status);
    bytes_out(&hits->leaves, from, count, b.leaves, b.status);
    bytes_out(&hits->status, from, count, b.status, NULL);
    rest_of_block(m, &b, from);
}

static bool all_stride(const sure_numbers *columns, int count, ptrdiff_t stride)
{
    for (int k = 0; k < count; k++)
        if (columns[k].stride != stride)
            return false;
    return true;
}

static bool is_one_object(const sure_objects *objects)
{
    return all_stride(objects->numbers, numbers_of(objects->shape), 0);
}

/* Does nothing need room? Then a block may be as long as it likes. */
static bool all_stand(const many *m, size_t size, bool one_object)
{
    const sure_hits *hits = m->hits;
    const ptrdiff_t step = (ptrdiff_t)size;
    return !wants_normals(hits) && hits->status.stride == 1 &&
           (!hits->part.first || hits->part.stride == 1) &&
           (!hits->leaves.first || hits->leaves.stride == 1) &&
           (!hits->t.first || hits->t.stride == step) &&
           (!hits->t_error.first || hits->t_error.stride == step) &&
           all_stride((const void *)m->rays, RAY_NUMBERS, step) &&
           (one_object || all_stride(m->objects->numbers, numbers_of(m->objects->shape), step));
}

/* How many of them block_hits answers; too few are not worth it. */
static INLINED size_t blocks_hits(const many *m, size_t count, size_t size,
                                  const block_stage *stages)
{
    block_room room;
    const bool one_object = is_one_object(m->objects);
    const size_t most = count > BLOCK && all_stand(m, size, one_object) ? count : BLOCK;
    size_t done = 0;
    for (size_t left = count; stages && left >= BLOCK_LEAST; left = count - done) {
        const size_t now = left < most ? left : most;
        block_hits(m, &stages[m->objects->shape], &room, done, now, size, one_object);
        done += now;
    }
    return done;
}

static void answer_from(const many *m, size_t done, size_t count)
{
    for (size_t i = done; i < count; i++)
        answer_alone(m, i);
}

void sure_objects_hits(size_t count, const sure_rays *rays, const sure_objects *objects,
                       sure_tier tier, const sure_hits *hits)
{
    assert(hits->status.first || count == 0);
    sure_object object = {.shape = objects->shape};
    many m = {rays, objects, hits, tier, false, NULL};
    const bool blocks = tier == SURE_TIER_CERTAIN;
    if (count > 0 && is_one_object(objects)) { /* which is read once */
        gather_object(&m, 0, sizeof(double), &object.as);
        m.object = &object;
    }
    answer_from(&m, blocks ? blocks_hits(&m, count, sizeof(double), block_stages()) : 0, count);
}

void sure_objects_hits_certain_f(size_t count, const sure_rays *rays, const sure_objects *objects,
                                 const sure_hits *hits)
{
    assert((hits->status.first && !hits->t_error.first) || count == 0);
    const many m = {rays, objects, hits, SURE_TIER_CERTAIN, true, NULL};
    const bool blocks = environment_is_default();
    answer_from(&m, blocks ? blocks_hits(&m, count, sizeof(float), block_stages_f()) : 0, count);
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
    HITS(shape, SHAPE, exact, EXACT)                                                               \
    void sure_##shape##_hits_certain_f(size_t count, const sure_rays *rays,                        \
                                       const sure_##shape##_f *shape, const sure_hits *hits)       \
    {                                                                                              \
        const sure_objects objects = sure_objects_of_f(SURE_SHAPE_##SHAPE, shape, 0);              \
        sure_objects_hits_certain_f(count, rays, &objects, hits);                                  \
    }
SURE_EACH_SHAPE(HITS_OF_SHAPE)
