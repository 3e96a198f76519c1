/* SPDX-License-Identifier: MIT */
/* What a ray meets in a scene, each object asked, or those whose boxes it meets. */
#pragma once

#include <surehit/scene.h>

#include <stdbool.h>

/* The tiers whose decisions are right. */
static inline bool is_sure(sure_tier tier)
{
    return tier == SURE_TIER_CERTAIN || tier == SURE_TIER_EXACT;
}

/* Any object that the ray meets, as sure_backward_nearest: SURE_HIT and *object, or SURE_MISS. */
sure_status visible_any(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                        const sure_surface_point *leaving, size_t *object);
