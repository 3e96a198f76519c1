/* The plane's point, if it is not too far from the centre Q. With m = o - Q, speed = N.d and
 * t = -N.m / speed,
 *
 *     speed (m + t d) = speed m - (N.m) d = f,  hit when f.f <= r^2 speed^2
 *
 * A line in the plane (speed = N.m = 0) is cut by the circle |m + t d|^2 = r^2, as by a sphere:
 *
 *     a = d.d,  b = m.d,  c = m.m - r^2,  b^2 - a c = r^2 d.d - |d x m|^2
 */
#include "../../stages/line.h"

static chord edge_on(context *c, vector d, vector m, number rr, line *l)
{
    l->a = vector_square(c, d);
    number wide = vector_square(c, vector_cross(c, d, m));
    l->quarter = number_sub(c, number_mul(c, rr, l->a), wide);
    if (number_sign(c, l->quarter) < 0)
        return chord_empty();
    l->factor = number_of(c, 1);
    l->b = vector_dot(c, m, d);
    l->c = number_sub(c, vector_square(c, m), rr);
    return chord_along((chord_end){POINT_LESS, SURE_PART_SURFACE},
                       (chord_end){POINT_MORE, SURE_PART_SURFACE}, SURE_PART_SURFACE);
}

chord STAGE(disc_chord)(context *c, const sure_ray *ray, const sure_disc *disc, line *l)
{
    vector normal = vector_of(c, disc->normal), d = vector_of(c, ray->direction);
    vector m = vector_between(c, disc->centre, ray->origin);
    number rr = number_square(c, number_of(c, disc->radius));
    number height = vector_dot(c, normal, m);
    l->speed = vector_dot(c, normal, d);
    l->base = number_negate(c, height);
    if (number_sign(c, l->speed) == 0)
        return number_sign(c, height) == 0 ? edge_on(c, d, m, rr, l) : chord_empty();
    vector foot = vector_sub(c, vector_scale(c, l->speed, m), vector_scale(c, height, d));
    number reach = number_mul(c, rr, number_square(c, l->speed));
    if (number_sign(c, number_sub(c, reach, vector_square(c, foot))) < 0)
        return chord_empty();
    return chord_point((chord_end){POINT_BASE, SURE_PART_SURFACE});
}
