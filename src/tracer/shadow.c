/* SPDX-License-Identifier: MIT */
#include "../numbers/sums.h"

#include <surehit/shadow.h>

#include "statistics.h"
#include "visible.h"

/* The light itself, at t = 1, is no obstacle: the largest number of the tier below 1. */
static double before_light(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1.fffffep-1 : 0x1.fffffffffffffp-1;
}

bool shadow_reaches(const tracing *t, const sure_surface_point *from, sure_vec3 light_position)
{
    double x = from->point.x, y = from->point.y, z = from->point.z;
    sure_ray ray = {.origin = {x, y, z}, /* one by one, as they have just been written */
                    .direction = {light_position.x - x, light_position.y - y, light_position.z - z},
                    .t_max = before_light(t->tier)};
    size_t blocking = 0;
    sure_status met = visible_any(t->scene, t->tier, &ray, from, &light_position, &blocking);
    statistics_ray(t, SURE_RAY_SHADOW, &ray, from, met, blocking);
    return met != SURE_HIT;
}

unsigned shadow_reach(const tracing *t, const sure_surface_point *const *from, size_t count,
                      sure_vec3 light_position)
{
    unsigned reached = 0;
    packet rays;
    if (t->together && count >= PACKET_LEAST) {
        rays.count = 0;
        rays.light = &light_position;
        for (size_t i = 0; i < count; i++) {
            const sure_vec3 way = difference_of(light_position, from[i]->point);
            packet_add(&rays, &from[i]->point, &way, 0, before_light(t->tier), from[i]);
        }
        return ~t->together->any(t->scene, &rays);
    }
    for (size_t i = 0; i < count; i++)
        reached |= (unsigned)shadow_reaches(t, from[i], light_position) << i;
    return reached;
}

int sure_shadow_reaches(const sure_scene *scene, sure_tier tier, const sure_surface_point *from,
                        sure_vec3 light_position)
{
    const tracing t = {scene, tier, NULL, NULL};
    return shadow_reaches(&t, from, light_position);
}
