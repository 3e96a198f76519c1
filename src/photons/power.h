/* What a light has to give, by which photons choose one. */
#ifndef PHOTONS_POWER_H
#define PHOTONS_POWER_H

#include "../numbers/bits.h"

#include <surehit/scene.h>

static inline double mean(sure_vec3 color)
{
    return (color.x + color.y + color.z) / 3;
}

static inline double power_of(const sure_light *light)
{
    return light->brightness * mean(light->color);
}

/* Of all lights. */
static inline double total_power(const sure_scene *scene)
{
    double sum = 0;
    for (size_t i = 0; i < scene->light_count; i++)
        sum += power_of(&scene->lights[i]);
    return sum;
}

#endif
