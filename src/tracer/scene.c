#include "../arithmetic/ieee.h"

#include <surehit/scene.h>

#include <math.h>

sure_status sure_scene_meets_again(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                   const sure_surface_point *leaving, sure_hit *hit)
{
    sure_interval chord;
    if (!leaving->inside ||
        sure_object_interval(ray, &scene->objects[leaving->object], tier, &chord) != SURE_HIT)
        return SURE_MISS;
    if (!(chord.t_leave > ray->t_min && chord.t_leave <= ray->t_max))
        return SURE_MISS;
    *hit = (sure_hit){chord.t_leave, INFINITY, chord.leave_part};
    return SURE_HIT;
}
