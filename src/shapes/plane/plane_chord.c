/* N.(o + t d - Q) = 0 with m = o - Q:
 *
 *     speed = N.d,  t = -N.m / N.d
 *
 * speed = 0: the whole line when N.m = 0, nothing otherwise. */
#include "../../stages/line.h"

chord STAGE(plane_chord)(context *c, const sure_ray *ray, const sure_plane *plane, line *l)
{
    vector normal = vector_of(c, plane->normal);
    l->speed = vector_dot(c, normal, vector_of(c, ray->direction));
    number height = vector_dot(c, normal, vector_between(c, plane->point, ray->origin));
    l->base = number_negate(c, height);
    if (number_sign(c, l->speed) != 0)
        return chord_point((chord_end){POINT_BASE, SURE_PART_SURFACE});
    chord_end none = {POINT_ENDLESS, SURE_PART_SURFACE};
    return number_sign(c, height) == 0 ? chord_along(none, none, SURE_PART_SURFACE) : chord_empty();
}
