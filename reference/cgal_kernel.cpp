/* The second route for plane, disc and sphere: CGAL intersects the line itself, with its linear
 * kernel and its spherical kernel, and t is read off a coordinate of the point that it returns.
 * Rounding too goes another way, by bisection over all doubles. */
#include "reference.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Algebraic_kernel_for_spheres_2_3.h>
#include <CGAL/Spherical_kernel_3.h>
#include <CGAL/iterator.h>

#include "cgal_environment.h"
#include "cgal_kernel.h"

using namespace exact;

namespace {

using numbers = CGAL::Algebraic_kernel_for_spheres_2_3<rational>;
using spherical = CGAL::Spherical_kernel_3<kernel, numbers>;
using algebraic = spherical::Root_of_2;

/* Tells the time t at which a line passes a point by a coordinate in which it moves. */
class line_clock {
public:
    explicit line_clock(const sure_ray &ray)
    {
        const std::array<double, 3> o = {ray.origin.x, ray.origin.y, ray.origin.z};
        const std::array<double, 3> d = {ray.direction.x, ray.direction.y, ray.direction.z};
        while (order_key(d[axis_]) == 0)
            axis_++;
        origin_ = to_rational(to_dyadic(o[axis_]));
        step_ = to_rational(to_dyadic(d[axis_]));
    }

    template <class point> algebraic coordinate(const point &p) const
    {
        return algebraic(axis_ == 0 ? p.x() : axis_ == 1 ? p.y() : p.z());
    }

    /* Sign of t - x. */
    int compare(const algebraic &coordinate, const rational &x) const
    {
        return CGAL::compare(coordinate, rational(origin_ + x * step_)) * step_.sign();
    }

    bool before(const algebraic &one, const algebraic &other) const
    {
        return CGAL::compare(one, other) * step_.sign() < 0;
    }

private:
    std::size_t axis_ = 0;
    rational origin_, step_;
};

/* Infinities stand for +-2^1024 here, their place in rounding. */
rational value(int64_t key)
{
    return to_rational(to_dyadic(from_order_key(key)));
}

double nearest_time(const line_clock &clock, const algebraic &coordinate)
{
    const int64_t last = order_key(std::numeric_limits<double>::infinity());
    const bool negative = clock.compare(coordinate, rational(0)) < 0;
    int64_t low = negative ? -last : 0, high = negative ? 0 : last;
    while (high - low > 1) {
        const int64_t middle = low + (high - low) / 2;
        if (clock.compare(coordinate, value(middle)) >= 0)
            low = middle;
        else
            high = middle;
    }
    const int side = clock.compare(coordinate, (value(low) + value(high)) / 2);
    const int64_t even = low % 2 == 0 ? low : high;
    return from_order_key(side < 0 ? low : side > 0 ? high : even);
}

/* What the line has in common with an object: the whole line, or the points between two. */
struct common_points {
    bool whole_line;
    std::vector<algebraic> ends;
};

spherical::Point_3 as_spherical(const kernel::Point_3 &p)
{
    return {p.x(), p.y(), p.z()};
}

/* The spherical kernel refuses a sphere that is a point. */
common_points sphere_and_line(const line_clock &clock, const sure_vec3 &centre, double radius,
                              const kernel::Line_3 &line)
{
    using met = std::pair<spherical::Circular_arc_point_3, unsigned>;
    const kernel::Point_3 middle = kernel_point(centre);
    common_points common = {false, {}};
    if (squared(radius) == 0) {
        if (line.has_on(middle))
            common.ends = {clock.coordinate(middle)};
        return common;
    }
    const spherical::Line_3 same_line(as_spherical(line.point(0)), as_spherical(line.point(1)));
    const spherical::Sphere_3 sphere(as_spherical(middle), squared(radius));
    std::vector<met> points;
    CGAL::intersection(same_line, sphere,
                       CGAL::dispatch_or_drop_output<met>(std::back_inserter(points)));
    for (const met &point : points)
        common.ends.push_back(clock.coordinate(point.first));
    return common;
}

common_points plane_and_line(const line_clock &clock, const kernel::Plane_3 &plane,
                             const kernel::Line_3 &line)
{
    const auto met = CGAL::intersection(plane, line);
    if (!met)
        return {false, {}};
    if (const kernel::Point_3 *point = boost::get<kernel::Point_3>(&*met))
        return {false, {clock.coordinate(*point)}};
    return {true, {}};
}

common_points disc_and_line(const line_clock &clock, const sure_disc &disc,
                            const kernel::Line_3 &line)
{
    const kernel::Point_3 centre = kernel_point(disc.centre);
    const kernel::Plane_3 plane(centre, kernel_vector(disc.normal));
    const auto met = CGAL::intersection(plane, line);
    if (!met)
        return {false, {}};
    const kernel::Point_3 *point = boost::get<kernel::Point_3>(&*met);
    if (!point)
        return sphere_and_line(clock, disc.centre, disc.radius, line);
    if (CGAL::squared_distance(*point, centre) > squared(disc.radius))
        return {false, {}};
    return {false, {clock.coordinate(*point)}};
}

common_points meet(const line_clock &clock, const sure_ray &ray, const sure_object &object)
{
    const kernel::Line_3 line(kernel_point(ray.origin), kernel_vector(ray.direction));
    switch (object.shape) {
    case SURE_SHAPE_PLANE:
        return plane_and_line(clock,
                              kernel::Plane_3(kernel_point(object.as.plane.point),
                                              kernel_vector(object.as.plane.normal)), line);
    case SURE_SHAPE_DISC:
        return disc_and_line(clock, object.as.disc, line);
    case SURE_SHAPE_SPHERE:
        return sphere_and_line(clock, object.as.sphere.centre, object.as.sphere.radius, line);
    default:
        contradiction("a shape that CGAL has no kernel for");
    }
}

sure_status interval_by_kernel(const sure_ray &ray, const sure_object &object,
                               sure_interval *interval)
{
    const line_clock clock(ray);
    const common_points common = meet(clock, ray, object);
    interval->enter_part = interval->leave_part = SURE_PART_SURFACE;
    if (common.whole_line) {
        interval->t_leave = std::numeric_limits<double>::infinity();
        interval->t_enter = -interval->t_leave;
        return SURE_HIT;
    }
    if (common.ends.empty())
        return SURE_MISS;
    algebraic first = common.ends.front(), last = common.ends.back();
    if (clock.before(last, first))
        std::swap(first, last);
    const bool begun = clock.compare(last, to_rational(to_dyadic(ray.t_min))) >= 0;
    const bool ended = is_finite(ray.t_max) &&
                       clock.compare(first, to_rational(to_dyadic(ray.t_max))) > 0;
    if (!begun || ended)
        return SURE_MISS;
    interval->t_enter = nearest_time(clock, first);
    interval->t_leave = nearest_time(clock, last);
    return SURE_HIT;
}

}

extern "C" sure_status reference_kernel_interval(const sure_ray *ray, const sure_object *object,
                                                 sure_interval *interval)
{
    if (reference_check(ray, object) != SURE_FIELD_NONE)
        return SURE_INVALID;
    const default_environment guard;
    sure_interval found;
    const sure_status status = interval_by_kernel(*ray, *object, &found);
    if (status == SURE_HIT && interval)
        *interval = found;
    return status;
}
