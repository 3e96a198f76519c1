/* SPDX-License-Identifier: MIT */
/* Disc. It keeps the tau of its plane (cgal_plane.h) with |m + tau d|^2 <= r^2; on a line in its
 * plane that is the sphere's quadratic (cgal_sphere.cpp). The whole chord belongs to the set, so
 * none of it is interior. */
#include "cgal_plane.h"

namespace exact {

namespace {

class disc_question : public plane_question {
public:
    disc_question(const line &on, const vector &centre, const vector &normal, const integer &radius)
        : plane_question(on, centre, normal), m_(on.origin - centre), radius_(radius),
          circle_(sphere_quadratic(m_, on.direction, radius))
    {
    }

    span chord() const override
    {
        if (slope_.sign() != 0)
            return cap() <= 0 ? between(crossing(), crossing(), false) : nothing();
        if (height_.sign() != 0 || circle_.discriminant() < 0)
            return nothing();
        return between(circle_.low_root(on_), circle_.high_root(on_), false);
    }

    reference_decisions decisions() const override
    {
        reference_decisions signs = plane_question::decisions();
        if (signs.axis != 0)
            signs.base_cap = cap();
        else
            signs.discriminant = circle_.discriminant();
        return signs;
    }

private:
    int cap() const { return distance_sign(m_, on_.direction, radius_, crossing()); }

    vector m_;
    integer radius_;
    quadratic circle_;
};

sure_field check(const sure_object &object)
{
    const sure_disc &disc = object.as.disc;
    return check_radius(check_facing(disc.centre, SURE_FIELD_CENTRE, disc.normal), disc.radius);
}

std::unique_ptr<question> ask_disc(const sure_ray &ray, const sure_object &object)
{
    const sure_disc &disc = object.as.disc;
    common_unit length;
    length.show(ray.origin).show(disc.centre).show(disc.radius);
    return std::make_unique<disc_question>(make_line(ray, length), length.count(disc.centre),
                                           count_alone(disc.normal), length.count(disc.radius));
}

kernel::Plane_3 kernel_plane(const sure_object &object)
{
    return {kernel_point(object.as.disc.centre), kernel_vector(object.as.disc.normal)};
}

std::vector<layer> layers(const sure_object &object)
{
    const kernel::Point_3 centre = kernel_point(object.as.disc.centre);
    return {{centre, centre, kernel_vector(object.as.disc.normal)}};
}

rational surface(const sure_object &object, const kernel::Point_3 &p)
{
    return CGAL::squared_distance(kernel_point(object.as.disc.centre), p) -
           squared(object.as.disc.radius);
}

int where(const sure_object &object, const kernel::Point_3 &p)
{
    return kernel_plane(object).has_on(p) && surface(object, p) <= 0 ? 0 : 1;
}

common_points meet(const sure_object &object, const kernel::Line_3 &line)
{
    const auto met = CGAL::intersection(kernel_plane(object), line);
    if (!met)
        return {false, {}, std::nullopt};
    const kernel::Point_3 *point = boost::get<kernel::Point_3>(&*met);
    if (!point)
        return {false,
                {},
                common_points::ball{kernel_point(object.as.disc.centre),
                                    squared(object.as.disc.radius)}};
    if (surface(object, *point) > 0)
        return {false, {}, std::nullopt};
    return {false, {*point}, std::nullopt};
}

fields fields_of(const sure_object &object)
{
    return {object.as.disc.centre, {}, object.as.disc.normal, object.as.disc.radius};
}

int side(const frame &object, const point &q, const integer &w)
{
    if (sign(dot(object.axis, q)) != 0)
        return 1;
    return sign(square(q) - square(integer(object.radius * w))) > 0 ? 1 : 0;
}

}

extern const shape_row disc_row = {check,  ask_disc,  where, layers,           surface,
                                   meet,   fields_of, side,  way_out_of_plane, nullptr,
                                   nullptr};

}
