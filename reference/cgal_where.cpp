/* A point against an object by CGAL's exact kernel: rational points, lines, planes and spheres,
 * whose predicates and constructions do not round over rationals. No formula is shared with the
 * chords: distances to an axis are taken to the foot on it, not by cross products. */
#include "reference.h"

#include <algorithm>

#include "cgal_kernel.h"

namespace exact {

namespace {

/* The larger of two sides is that of an intersection of convex bodies. */
int against_layer(const layer &between, const kernel::Point_3 &p)
{
    const int beneath = -kernel::Plane_3(between.low, between.axis).oriented_side(p);
    const int beyond = kernel::Plane_3(between.high, between.axis).oriented_side(p);
    return std::max(beneath, beyond);
}

/* Sphere_3 takes the squared radius: it is squared here, exactly. */
int against_sphere(const sure_sphere &sphere, const kernel::Point_3 &p)
{
    const kernel::Sphere_3 surface(kernel_point(sphere.centre), squared(sphere.radius));
    return -surface.bounded_side(p);
}

int against_disc(const sure_disc &disc, const kernel::Point_3 &p)
{
    const kernel::Point_3 centre = kernel_point(disc.centre);
    const kernel::Plane_3 plane(centre, kernel_vector(disc.normal));
    return plane.has_on(p) && CGAL::squared_distance(centre, p) <= squared(disc.radius) ? 0 : 1;
}

rational cylinder_value(const sure_cylinder &cylinder, const kernel::Point_3 &p)
{
    const kernel::Line_3 axis(kernel_point(cylinder.base), kernel_point(cylinder.top));
    return CGAL::squared_distance(axis.projection(p), p) - squared(cylinder.radius);
}

/* At the foot's share of the way from apex to base the cone has that share of the radius. */
rational cone_value(const sure_cone &cone, const kernel::Point_3 &p)
{
    const kernel::Point_3 apex = kernel_point(cone.apex), base = kernel_point(cone.base);
    const kernel::Point_3 foot = kernel::Line_3(apex, base).projection(p);
    const rational share_squared = CGAL::squared_distance(apex, foot) /
                                   CGAL::squared_distance(apex, base);
    return CGAL::squared_distance(foot, p) - share_squared * squared(cone.radius);
}

}

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

layer layer_of(const sure_object &object)
{
    kernel::Point_3 low, high;
    switch (object.shape) {
    case SURE_SHAPE_PLANE:
        low = kernel_point(object.as.plane.point);
        return {low, low, kernel_vector(object.as.plane.normal)};
    case SURE_SHAPE_DISC:
        low = kernel_point(object.as.disc.centre);
        return {low, low, kernel_vector(object.as.disc.normal)};
    case SURE_SHAPE_CYLINDER:
        low = kernel_point(object.as.cylinder.base);
        high = kernel_point(object.as.cylinder.top);
        return {low, high, high - low};
    case SURE_SHAPE_CONE:
        low = kernel_point(object.as.cone.base);
        high = kernel_point(object.as.cone.apex);
        return {low, high, high - low};
    default:
        contradiction("a shape without end planes");
    }
}

rational surface_value(const sure_object &object, const kernel::Point_3 &p)
{
    switch (object.shape) {
    case SURE_SHAPE_DISC:
        return CGAL::squared_distance(kernel_point(object.as.disc.centre), p) -
               squared(object.as.disc.radius);
    case SURE_SHAPE_SPHERE:
        return CGAL::squared_distance(kernel_point(object.as.sphere.centre), p) -
               squared(object.as.sphere.radius);
    case SURE_SHAPE_CYLINDER:
        return cylinder_value(object.as.cylinder, p);
    case SURE_SHAPE_CONE:
        return cone_value(object.as.cone, p);
    default:
        contradiction("a shape without a curved surface");
    }
}

int where(const sure_object &object, const kernel::Point_3 &p)
{
    switch (object.shape) {
    case SURE_SHAPE_PLANE:
        return kernel::Plane_3(kernel_point(object.as.plane.point),
                               kernel_vector(object.as.plane.normal)).oriented_side(p);
    case SURE_SHAPE_DISC:
        return against_disc(object.as.disc, p);
    case SURE_SHAPE_SPHERE:
        return against_sphere(object.as.sphere, p);
    default:
        return std::max(static_cast<int>(CGAL::sign(surface_value(object, p))),
                        against_layer(layer_of(object), p));
    }
}

}

extern "C" {

int reference_where(const sure_object *object, sure_vec3 point)
{
    return exact::where(*object, exact::kernel_point(point));
}

int reference_where_at(const sure_ray *ray, const sure_object *object, double t)
{
    const exact::rational time = exact::to_rational(exact::to_dyadic(t));
    return exact::where(*object, exact::kernel_point(ray->origin) +
                                     time * exact::kernel_vector(ray->direction));
}

}
