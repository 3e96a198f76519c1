/* SPDX-License-Identifier: MIT */
/* The table of shapes. Whoever adds one adds its row here, and nowhere else does the library ask
 * which shape it has. */
#include "../stages/hits/surface.h"
#include "../stages/rows.h"
#include "../stages/stages.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ROW(shape, SHAPE) &shape##_row,
const shape_row *const shape_rows[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
#undef ROW

const sure_shape_info *sure_shape_info_of(sure_shape shape)
{
    assert((unsigned)shape < SURE_SHAPES);
    return &shape_rows[shape]->info;
}

const char *sure_shape_name(sure_shape shape)
{
    return (unsigned)shape < SURE_SHAPES ? shape_rows[shape]->info.name : NULL;
}

int sure_shape_from_name(const char *name, sure_shape *shape)
{
    for (int i = 0; i < SURE_SHAPES; i++) {
        if (strcmp(name, shape_rows[i]->info.name) == 0) {
            *shape = (sure_shape)i;
            return 1;
        }
    }
    return 0;
}

/* The same call for each shape: CALL(plane) for a plane, ... */
#define BY_SHAPE(object, CASE)                                                                     \
    switch ((object)->shape) {                                                                     \
        SURE_EACH_SHAPE(CASE)                                                                      \
    }                                                                                              \
    abort() /* no member of sure_shape */

/* ... and for one tier of it. */
#define BY_TIER(tier, function, ...)                                                               \
    ((tier) == SURE_TIER_FLOAT32    ? function##_float32(__VA_ARGS__)                              \
     : (tier) == SURE_TIER_TEXTBOOK ? function##_textbook(__VA_ARGS__)                             \
     : (tier) == SURE_TIER_STABLE   ? function##_stable(__VA_ARGS__)                               \
     : (tier) == SURE_TIER_CERTAIN  ? function##_certain(__VA_ARGS__)                              \
                                    : function##_exact(__VA_ARGS__))

void sure_object_bounds(const sure_object *object, sure_vec3 *low, sure_vec3 *high)
{
    assert((unsigned)object->shape < SURE_SHAPES);
    const shape_row *row = row_of(object);
    const double end = row->surface->bounds ? INFINITY : -INFINITY;
    *low = (sure_vec3){end, end, end};
    *high = (sure_vec3){-end, -end, -end};
    if (row->surface->bounds)
        row->surface->bounds(&object->as, (void *)low, (void *)high);
}

sure_field sure_object_check(const sure_ray *ray, const sure_object *object)
{
    assert((unsigned)object->shape < SURE_SHAPES);
#define CHECK(shape, SHAPE)                                                                        \
    case SURE_SHAPE_##SHAPE: return sure_##shape##_check(ray, &object->as.shape);
    BY_SHAPE(object, CHECK);
}

sure_status sure_object_hit(const sure_ray *ray, const sure_object *object, sure_tier tier,
                            sure_hit *hit)
{
    assert((unsigned)object->shape < SURE_SHAPES && (unsigned)tier < SURE_TIERS);
#define HIT(shape, SHAPE)                                                                          \
    case SURE_SHAPE_##SHAPE: return BY_TIER(tier, sure_##shape##_hit, ray, &object->as.shape, hit);
    BY_SHAPE(object, HIT);
}

sure_status sure_object_interval(const sure_ray *ray, const sure_object *object, sure_tier tier,
                                 sure_interval *interval)
{
    assert((unsigned)object->shape < SURE_SHAPES && (unsigned)tier < SURE_TIERS);
#define INTERVAL(shape, SHAPE)                                                                     \
    case SURE_SHAPE_##SHAPE:                                                                       \
        return BY_TIER(tier, sure_##shape##_interval, ray, &object->as.shape, interval);
    BY_SHAPE(object, INTERVAL);
}

sure_status sure_object_occluded(const sure_ray *ray, const sure_object *object, sure_tier tier)
{
    assert((unsigned)object->shape < SURE_SHAPES && (unsigned)tier < SURE_TIERS);
#define OCCLUDED(shape, SHAPE)                                                                     \
    case SURE_SHAPE_##SHAPE: return BY_TIER(tier, sure_##shape##_occluded, ray, &object->as.shape);
    BY_SHAPE(object, OCCLUDED);
}

sure_vec3 sure_object_normal(const sure_ray *ray, const sure_object *object, sure_tier tier,
                             const sure_hit *hit)
{
    assert((unsigned)object->shape < SURE_SHAPES && (unsigned)tier < SURE_TIERS);
#define NORMAL(shape, SHAPE)                                                                       \
    case SURE_SHAPE_##SHAPE:                                                                       \
        return BY_TIER(tier, sure_##shape##_normal, ray, &object->as.shape, hit);
    BY_SHAPE(object, NORMAL);
}

sure_stage sure_object_stage(const sure_ray *ray, const sure_object *object, sure_tier tier)
{
    assert((unsigned)object->shape < SURE_SHAPES && (unsigned)tier < SURE_TIERS);
    if (tier < SURE_TIER_CERTAIN)
        return SURE_STAGE_DOUBLE;
    t_wanted wanted = tier == SURE_TIER_EXACT ? T_EXACT : T_CERTAIN;
    sure_hit unused;
    sure_stage stage;
    (void)stages_hit(row_of(object), ray, &object->as, wanted, &unused, &stage);
    return stage;
}
