/* SPDX-License-Identifier: MIT */
/* A point against an object by CGAL's exact kernel: rational points, lines, planes and spheres,
 * whose predicates and constructions do not round over rationals. No formula is shared with the
 * chords: distances to an axis are taken to the foot on it, not by cross products. */
#include "reference.h"

#include "cgal_shape.h"

namespace exact {

kernel::Point_3 kernel_point(const sure_vec3 &p)
{
    return {to_rational(to_dyadic(p.x)), to_rational(to_dyadic(p.y)), to_rational(to_dyadic(p.z))};
}

kernel::Vector_3 kernel_vector(const sure_vec3 &v)
{
    return {to_rational(to_dyadic(v.x)), to_rational(to_dyadic(v.y)), to_rational(to_dyadic(v.z))};
}

rational squared(double x)
{
    return CGAL::square(to_rational(to_dyadic(x)));
}

}

extern "C" {

int reference_where(const sure_object *object, sure_vec3 point)
{
    return exact::row_of(*object).where(*object, exact::kernel_point(point));
}

int reference_where_at(const sure_ray *ray, const sure_object *object, double t)
{
    const exact::rational time = exact::to_rational(exact::to_dyadic(t));
    return exact::row_of(*object).where(*object, exact::kernel_point(ray->origin) +
                                                     time * exact::kernel_vector(ray->direction));
}
}
