/* SPDX-License-Identifier: MIT */
#include "../../numbers/places.h"
#include "../floats.h"

#include "../rows.h"
#include "beyond.h"

#include <assert.h>

/* What floats say, in doubles. */
typedef struct {
    sure_ray ray;
    sure_object object;
} wide_query;

static wide_query wide_of(const sure_ray_f *ray, const void *shape, sure_shape which)
{
    wide_query q = {.object.shape = which};
    floats_widen(ray, sizeof q.ray / sizeof(double), &q.ray);
    floats_widen(shape, (size_t)shape_rows[which]->info.numbers, &q.object.as);
    return q;
}

/* x is a correctly rounded number. Do both of its neighbours become the same float? Then it is what
 * the number itself becomes. */
static bool is_settled(double x)
{
    if (!is_finite_bits(x))
        return true;
    int64_t place = place_of(x);
    return (float)at_place(place - 1) == (float)at_place(place + 1);
}

/* -0 is none. */
static float float_of(double x)
{
    return (float)x + 0.0F;
}

/* Entry everywhere below: the default environment. */

/* What certain does not tell exact does, and where its t is a tie, that of the exact numbers. */
static float rounded_t(const wide_query *q, const sure_hit *found)
{
    float t;
    sure_hit right;
    if (found->t_error <= found->t && floats_round(found->t, found->t_error, &t))
        return float_of(t);
    (void)sure_object_hit(&q->ray, &q->object, SURE_TIER_EXACT, &right);
    return float_of(is_settled(right.t) ? right.t
                                        : odd_t(&q->ray, row_of(&q->object), &q->object.as));
}

static NOT_INLINED sure_status hit_by_default(const sure_ray_f *ray, const void *shape,
                                              sure_hit_f *hit, sure_shape which)
{
    const wide_query q = wide_of(ray, shape, which);
    sure_hit found;
    sure_status status = sure_object_hit(&q.ray, &q.object, SURE_TIER_CERTAIN, &found);
    if (status == SURE_HIT)
        *hit = (sure_hit_f){rounded_t(&q, &found), found.part, found.leaves};
    return status;
}

static NOT_INLINED sure_field check_by_default(const sure_ray_f *ray, const void *shape,
                                               sure_shape which)
{
    const wide_query q = wide_of(ray, shape, which);
    return sure_object_check(&q.ray, &q.object);
}

static NOT_INLINED sure_float_vec3 normal_by_default(const sure_ray_f *ray, const void *shape,
                                                     const sure_hit_f *hit, sure_shape which,
                                                     sure_tier tier)
{
    const wide_query q = wide_of(ray, shape, which);
    sure_hit found;
    sure_status status = sure_object_hit(&q.ray, &q.object, tier, &found);
    assert(status == SURE_HIT && found.part == hit->part);
    (void)status, (void)hit;
    sure_vec3 n = sure_object_normal(&q.ray, &q.object, tier, &found);
    if (tier == SURE_TIER_EXACT && !(is_settled(n.x) && is_settled(n.y) && is_settled(n.z)))
        n = odd_normal(&q.ray, row_of(&q.object), &q.object.as);
    return (sure_float_vec3){float_of(n.x), float_of(n.y), float_of(n.z)};
}

/* In any environment. */

sure_status floats_rest_of_hit(const sure_ray_f *ray, const void *shape, sure_hit_f *hit,
                               sure_shape which)
{
    sure_status status;
    TO_DEFAULT(status, hit_by_default(ray, shape, hit, which));
    return status;
}

sure_field floats_check(const sure_ray_f *ray, const void *shape, sure_shape which)
{
    sure_field field;
    TO_DEFAULT(field, check_by_default(ray, shape, which));
    return field;
}

sure_float_vec3 floats_normal(const sure_ray_f *ray, const void *shape, const sure_hit_f *hit,
                              sure_shape which, sure_tier tier)
{
    sure_float_vec3 normal;
    TO_DEFAULT(normal, normal_by_default(ray, shape, hit, which, tier));
    return normal;
}
