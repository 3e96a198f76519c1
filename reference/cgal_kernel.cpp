/* SPDX-License-Identifier: MIT */
/* The second route for shapes that CGAL has a kernel for: it intersects the line itself, with its
 * linear and its spherical kernel, and t is read off a coordinate of the point that it returns.
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
#include "cgal_shape.h"

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

spherical::Point_3 as_spherical(const kernel::Point_3 &p)
{
    return {p.x(), p.y(), p.z()};
}

/* The spherical kernel refuses a sphere that is a point. */
std::vector<algebraic> meet_sphere(const line_clock &clock, const common_points::ball &ball,
                                   const kernel::Line_3 &line)
{
    using met = std::pair<spherical::Circular_arc_point_3, unsigned>;
    if (ball.squared_radius == 0)
        return line.has_on(ball.centre) ? std::vector<algebraic>{clock.coordinate(ball.centre)}
                                        : std::vector<algebraic>{};
    const spherical::Line_3 same_line(as_spherical(line.point(0)), as_spherical(line.point(1)));
    const spherical::Sphere_3 sphere(as_spherical(ball.centre), ball.squared_radius);
    std::vector<met> points;
    CGAL::intersection(same_line, sphere,
                       CGAL::dispatch_or_drop_output<met>(std::back_inserter(points)));
    std::vector<algebraic> ends;
    for (const met &point : points)
        ends.push_back(clock.coordinate(point.first));
    return ends;
}

std::vector<algebraic> ends_of(const line_clock &clock, const common_points &common,
                               const kernel::Line_3 &line)
{
    if (common.sphere)
        return meet_sphere(clock, *common.sphere, line);
    std::vector<algebraic> ends;
    for (const kernel::Point_3 &point : common.points)
        ends.push_back(clock.coordinate(point));
    return ends;
}

sure_status interval_by_kernel(const sure_ray &ray, const sure_object &object,
                               sure_interval *interval)
{
    const line_clock clock(ray);
    const kernel::Line_3 line(kernel_point(ray.origin), kernel_vector(ray.direction));
    if (!row_of(object).meet)
        contradiction("a shape that CGAL has no kernel for");
    const common_points common = row_of(object).meet(object, line);
    const std::vector<algebraic> ends = ends_of(clock, common, line);
    interval->enter_part = interval->leave_part = SURE_PART_SURFACE;
    if (common.whole_line) {
        interval->t_leave = std::numeric_limits<double>::infinity();
        interval->t_enter = -interval->t_leave;
        return SURE_HIT;
    }
    if (ends.empty())
        return SURE_MISS;
    algebraic first = ends.front(), last = ends.back();
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

extern "C" int reference_has_kernel(sure_shape shape)
{
    return row_of({shape, {}}).meet != nullptr;
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
