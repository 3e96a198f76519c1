/* SPDX-License-Identifier: MIT */
#include "sights.h"

#include "../../reference/reference.h"

/* Rounding keeps the order, so that only equal t need the order of the real ones. */
static int true_nearest(const sure_scene *scene, const sure_ray *ray)
{
    int nearest = SIGHT_NOTHING;
    double least = INFINITY, t;
    for (size_t i = 0; i < scene->object_count; i++) {
        int order = -1;
        if (reference_hit(ray, &scene->objects[i], &t, NULL, NULL) != SURE_HIT)
            continue;
        if (nearest != SIGHT_NOTHING)
            order = (t > least) - (t < least);
        if (order == 0)
            (void)reference_hit_order(ray, &scene->objects[i], &scene->objects[nearest], &order);
        if (order < 0) {
            nearest = (int)i;
            least = t;
        }
    }
    return nearest;
}

/* What the eye touches is not in front of it. */
static sure_ray pixel_ray(const sure_scene *scene, int i)
{
    const int row_from_top = i / scene->width;
    sure_ray ray = sure_scene_pixel_ray(scene, i % scene->width, scene->height - 1 - row_from_top);
    ray.t_min = 0x1p-1074;
    return ray;
}

sights sights_true(const sure_scene *scene)
{
    sights seen = sights_new(scene);
    for (int i = 0; i < scene->width * scene->height; i++) {
        const sure_ray ray = pixel_ray(scene, i);
        seen.objects[i] = true_nearest(scene, &ray);
    }
    return seen;
}
