#include "../arithmetic/ieee.h"

#include <surehit/shadow.h>

/* The light itself, at t = 1, is no obstacle: the largest number of the tier below 1. */
static double before_light(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1.fffffep-1 : 0x1.fffffffffffffp-1;
}

int sure_shadow_reaches(const sure_scene *scene, sure_tier tier, const sure_surface_point *from,
                        sure_vec3 light_position)
{
    sure_vec3 way = {light_position.x - from->point.x, light_position.y - from->point.y,
                     light_position.z - from->point.z};
    sure_ray ray = {from->point, way, 0, before_light(tier)};
    for (size_t i = 0; i < scene->object_count; i++) {
        if (i == from->object) {
            sure_hit again;
            if (sure_scene_meets_again(scene, tier, &ray, from, &again) == SURE_HIT)
                return 0;
        } else if (sure_object_occluded(&ray, &scene->objects[i], tier) == SURE_HIT) {
            return 0;
        }
    }
    return 1;
}
