/* SPDX-License-Identifier: MIT */
#include "../numbers/bits.h"

#include <surehit/shadow.h>

#include "statistics.h"
#include "visible.h"

/* The light itself, at t = 1, is no obstacle: the largest number of the tier below 1. */
static double before_light(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1.fffffep-1 : 0x1.fffffffffffffp-1;
}

static sure_ray ray_to(const tracing *t, const sure_surface_point *from, sure_vec3 light_position)
{
    double x = from->point.x, y = from->point.y, z = from->point.z;
    return (sure_ray){.origin = {x, y, z}, /* one by one, as they have just been written */
                      .direction = {light_position.x - x, light_position.y - y, light_position.z - z},
                      .t_max = before_light(t->tier)};
}

bool shadow_reaches(const tracing *t, const sure_surface_point *from, sure_vec3 light_position)
{
    sure_ray ray = ray_to(t, from, light_position);
    size_t blocking = 0;
    sure_status met = visible_any(t->scene, t->tier, &ray, from, &blocking);
    statistics_ray(t, SURE_RAY_SHADOW, &ray, from, met, blocking);
    return met != SURE_HIT;
}

unsigned shadow_reach(const tracing *t, size_t count, const sure_surface_point *const *from,
                      sure_vec3 light_position)
{
    unsigned reached = 0;
    if (!t->together || count < 2) {
        for (size_t i = 0; i < count; i++)
            reached |= (unsigned)shadow_reaches(t, from[i], light_position) << i;
        return reached;
    }
    packet rays;
    rays.count = count;
    for (size_t i = 0; i < count; i++) {
        rays.ray[i] = ray_to(t, from[i], light_position);
        rays.leaving[i] = from[i];
    }
    return ~t->together->any(t->scene, &rays);
}

int sure_shadow_reaches(const sure_scene *scene, sure_tier tier, const sure_surface_point *from,
                        sure_vec3 light_position)
{
    const tracing t = {scene, tier, NULL, NULL};
    return shadow_reaches(&t, from, light_position);
}
