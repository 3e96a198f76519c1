/* SPDX-License-Identifier: MIT */
/* What a ray meets in a scene, each object asked, or those whose boxes it meets. */
#pragma once

#include <surehit/hit_order.h>
#include <surehit/scene.h>

#include <stdbool.h>

/* The tiers whose decisions are right. */
static inline bool is_sure(sure_tier tier)
{
    return tier == SURE_TIER_CERTAIN || tier == SURE_TIER_EXACT;
}

/* Any object that the ray meets, as sure_backward_nearest: SURE_HIT and *object, or SURE_MISS. The
 * light that the ray leads to (NULL: none) may lie on an object, which is not met there. */
sure_status visible_any(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                        const sure_surface_point *leaving, const sure_vec3 *light, size_t *object);

/* The way to the light, its direction rounded, meets the object. Does it only come to the light,
 * which lies on the object (or within the one that it leaves from inside)? In the tiers that are
 * sure. */
bool visible_is_at_light(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                         const sure_surface_point *leaving, const sure_vec3 *light, size_t object);

/* Is that to be asked? No rounding leads to the light in the first half. */
static inline bool visible_may_be_at_light(const sure_vec3 *light, sure_tier tier,
                                           const sure_hit *hit)
{
    return light && is_sure(tier) && hit->t > 0.5;
}

/* Does the ray meet the object? Along the whole ray: how well t is known may depend on where a ray
 * ends, and the answer must not depend on which object was asked before. */
static inline bool visible_meets(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                 const sure_surface_point *leaving, size_t object, sure_hit *hit)
{
    if (leaving && leaving->object == object)
        return sure_scene_meets_again(scene, tier, ray, leaving, hit) == SURE_HIT;
    return sure_object_hit(ray, &scene->objects[object], tier, hit) == SURE_HIT;
}

/* Does it come before the nearest so far? By the real t* where the tier knows it; of two at one t
 * the object of the lower index does. */
static inline bool visible_is_nearer(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                     size_t object, const sure_hit *hit, const sure_nearest *than)
{
    const sure_object *objects = scene->objects;
    int order = (hit->t > than->hit.t) - (hit->t < than->hit.t);
    if (is_sure(tier))
        order = sure_hit_order(ray, &objects[object], hit, &objects[than->object], &than->hit);
    return order < 0 || (order == 0 && object < than->object);
}

/* No hit that comes before this one, or ties with it, lies beyond but by a rounding, for which
 * bvh_walk.h has room. */
static inline double visible_as_far_as(sure_tier tier, const sure_hit *hit, double so_far)
{
    double farthest = is_sure(tier) ? hit->t + hit->t_error : hit->t;
    return farthest < so_far ? farthest : so_far;
}
