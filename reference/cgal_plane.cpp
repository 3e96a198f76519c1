/* SPDX-License-Identifier: MIT */
/* Plane (cgal_plane.h). */
#include "cgal_plane.h"

namespace exact {

namespace {

sure_field check(const sure_object &object)
{
    return check_facing(object.as.plane.point, SURE_FIELD_POINT, object.as.plane.normal);
}

std::unique_ptr<question> ask_plane(const sure_ray &ray, const sure_object &object)
{
    const sure_plane &plane = object.as.plane;
    common_unit length;
    length.show(ray.origin).show(plane.point);
    return std::make_unique<plane_question>(make_line(ray, length), length.count(plane.point),
                                            count_alone(plane.normal));
}

kernel::Plane_3 kernel_plane(const sure_object &object)
{
    return {kernel_point(object.as.plane.point), kernel_vector(object.as.plane.normal)};
}

int where(const sure_object &object, const kernel::Point_3 &p)
{
    return kernel_plane(object).oriented_side(p);
}

std::vector<layer> layers(const sure_object &object)
{
    const kernel::Point_3 point = kernel_point(object.as.plane.point);
    return {{point, point, kernel_vector(object.as.plane.normal)}};
}

common_points meet(const sure_object &object, const kernel::Line_3 &line)
{
    const auto met = CGAL::intersection(kernel_plane(object), line);
    if (!met)
        return {false, {}, std::nullopt};
    if (const kernel::Point_3 *point = boost::get<kernel::Point_3>(&*met))
        return {false, {*point}, std::nullopt};
    return {true, {}, std::nullopt};
}

fields fields_of(const sure_object &object)
{
    return {object.as.plane.point, {}, object.as.plane.normal, 0};
}

int side(const frame &object, const point &q, const integer &)
{
    return sign(dot(object.axis, q)) == 0 ? 0 : 1;
}

}

extern const shape_row plane_row = {check,  ask_plane, where, layers,           nullptr,
                                    meet,   fields_of, side,  way_out_of_plane, nullptr,
                                    nullptr};

}
