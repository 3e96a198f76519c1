/* |m + t d|^2 = r^2 with m = o - C:
 *
 *     a = d.d,  b = m.d,  c = m.m - r^2
 *     b^2 - a c = r^2 d.d - ((m.m)(d.d) - (m.d)^2) = r^2 d.d - |d x m|^2
 *
 * the last by Lagrange's identity: two terms that are near each other only when the ray grazes. */
#include "../../stages/line.h"

chord STAGE(sphere_chord)(context *c, const sure_ray *ray, const sure_sphere *sphere, line *l)
{
    vector d = vector_of(c, ray->direction);
    vector m = vector_between(c, sphere->centre, ray->origin);
    number rr = number_square(c, number_of(c, sphere->radius));
    l->a = vector_square(c, d);
    number wide = vector_square(c, vector_cross(c, d, m));
    l->quarter = number_sub(c, number_mul(c, rr, l->a), wide);
    int crosses = number_sign(c, l->quarter);
    if (crosses < 0 || c->uncertain)
        return chord_empty();
    l->b = vector_dot(c, m, d);
    if (crosses == 0)
        return chord_point((chord_end){POINT_TOUCH, SURE_PART_SURFACE});
    l->factor = number_of(c, 1);
    l->c = number_sub(c, vector_square(c, m), rr);
    return chord_between((chord_end){POINT_LESS, SURE_PART_SURFACE},
                         (chord_end){POINT_MORE, SURE_PART_SURFACE});
}
