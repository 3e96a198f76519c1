/* What a ray meets in a scene, each object asked, or those whose boxes it meets. */
#ifndef TRACER_VISIBLE_H
#define TRACER_VISIBLE_H

#include <surehit/scene.h>

#include <stdbool.h>

/* The tiers whose decisions are right. */
static inline bool is_sure(sure_tier tier)
{
    return tier == SURE_TIER_CERTAIN || tier == SURE_TIER_EXACT;
}

/* The nearest object along the ray; `leaving` is the surface point that it comes from, or NULL. */
sure_status visible_nearest(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                            const sure_surface_point *leaving, sure_nearest *nearest);

/* Any object that the ray meets: SURE_HIT and *object, or SURE_MISS. */
sure_status visible_any(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                        const sure_surface_point *leaving, size_t *object);

#endif
