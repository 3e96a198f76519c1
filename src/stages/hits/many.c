#include <surehit/many.h>

#include <assert.h>
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

#define RAY_NUMBERS (int)(sizeof(sure_ray) / sizeof(double))
_Static_assert(sizeof(sure_rays) == RAY_NUMBERS * sizeof(sure_numbers), "a column a number");

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
    if (!hits->normal[0].first && !hits->normal[1].first && !hits->normal[2].first)
        return;
    sure_vec3 normal = sure_object_normal(ray, object, tier, &hit);
    put_number(&hits->normal[0], i, normal.x);
    put_number(&hits->normal[1], i, normal.y);
    put_number(&hits->normal[2], i, normal.z);
}

static void hits_of_one(size_t count, const sure_rays *rays, const sure_object *object,
                        sure_tier tier, const sure_hits *hits)
{
    sure_ray ray;
    assert(hits->status.first || count == 0);
    for (size_t i = 0; i < count; i++) {
        gather_ray(rays, i, &ray);
        put_answer(&ray, object, tier, hits, i);
    }
}

void sure_objects_hits(size_t count, const sure_rays *rays, const sure_objects *objects,
                       sure_tier tier, const sure_hits *hits)
{
    sure_ray ray;
    sure_object object = {.shape = objects->shape};
    const int numbers = sure_shape_info_of(objects->shape)->numbers;
    assert(hits->status.first || count == 0);
    for (size_t i = 0; i < count; i++) {
        gather_ray(rays, i, &ray);
        gather_object(objects, numbers, i, &object);
        put_answer(&ray, &object, tier, hits, i);
    }
}

#define HITS(name, NAME, tier_name, TIER)                                                          \
    void sure_##name##_hits_##tier_name(size_t count, const sure_rays *rays,                       \
                                        const sure_##name *name, const sure_hits *hits)            \
    {                                                                                              \
        const sure_object object = {SURE_SHAPE_##NAME, {.name = *name}};                           \
        hits_of_one(count, rays, &object, SURE_TIER_##TIER, hits);                                 \
    }
#define HITS_OF_SHAPE(shape, SHAPE)                                                                \
    HITS(shape, SHAPE, float32, FLOAT32)                                                           \
    HITS(shape, SHAPE, textbook, TEXTBOOK)                                                         \
    HITS(shape, SHAPE, stable, STABLE)                                                             \
    HITS(shape, SHAPE, certain, CERTAIN)                                                           \
    HITS(shape, SHAPE, exact, EXACT)
SURE_EACH_SHAPE(HITS_OF_SHAPE)
