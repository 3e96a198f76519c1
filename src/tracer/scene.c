/* SPDX-License-Identifier: MIT */
#include "../numbers/bits.h"

#include "pixel_ray.h"
#include "visible.h"

#include <surehit/rotation.h>
#include <surehit/scene.h>

#include <assert.h>
#include <math.h>

sure_ray sure_scene_pixel_ray(const sure_scene *scene, int column, int row)
{
    assert(pixel_scales_ok(&scene->camera));
    sure_vec3 direction =
        sure_pixel_ray_textbook(&scene->camera, scene->width, scene->height, column, row).direction;
    return (sure_ray){scene->camera.position, sure_rotation_undo_textbook(&scene->turn, direction),
                      0, INFINITY};
}

/* From a point that is inside indeed, so that the chord's beginning lies before the ray's and its
 * end is all that any part of the ray can meet. The beginning is so near that to tell it from t_min
 * takes more than doubles: the line from half of the way on will do, where its hit is certainly in
 * the ray's range or beyond. */
static sure_status leaves_surely(const sure_ray *ray, const sure_object *object, sure_tier tier,
                                 sure_hit *hit)
{
    sure_interval chord;
    sure_hit end;
    sure_ray rest = *ray;
    if (sure_object_interval(ray, object, tier, &chord) != SURE_HIT)
        return SURE_MISS;
    rest.t_min = fmax(ray->t_min, fmin(chord.t_leave / 2, ray->t_max));
    rest.t_max = INFINITY;
    if (sure_object_hit(&rest, object, tier, &end) == SURE_HIT) {
        if (end.t - ray->t_max > end.t_error)
            return SURE_MISS;
        if (ray->t_max - end.t > end.t_error) {
            *hit = end;
            return SURE_HIT;
        }
    }
    return sure_object_hit(ray, object, tier, hit);
}

sure_status sure_scene_meets_again(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                   const sure_surface_point *leaving, sure_hit *hit)
{
    assert(leaving->object < scene->object_count);
    const sure_object *object = &scene->objects[leaving->object];
    sure_interval chord;
    if (!leaving->inside)
        return SURE_MISS;
    if (is_sure(tier))
        return leaves_surely(ray, object, tier, hit);
    if (sure_object_interval(ray, object, tier, &chord) != SURE_HIT)
        return SURE_MISS;
    if (!(chord.t_leave > ray->t_min && chord.t_leave <= ray->t_max))
        return SURE_MISS;
    *hit = (sure_hit){chord.t_leave, INFINITY, chord.leave_part, 1};
    return SURE_HIT;
}
