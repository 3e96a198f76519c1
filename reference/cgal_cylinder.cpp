/* SPDX-License-Identifier: MIT */
/* Cylinder. q = P - base, A = top - base, H = A.A, m = o - base, P = o + tau d. Inside the endless
 * cylinder the part of q at right angles to A is at most r long: |q|^2 - (A.q)^2 / H <= r^2, so
 *
 *     F = H q.q - (A.q)^2 - r^2 H = a tau^2 + 2 b tau + c <= 0,
 *     a = H d.d - (A.d)^2,   b = H m.d - (A.d)(A.m),   c = H (m.m - r^2) - (A.m)^2.
 *
 * Second derivation: H times the distance squared is |A x q|^2 (area of a parallelogram), so with
 * P = A x m, Q = A x d: a = |Q|^2, b = P.Q, c = |P|^2 - r^2 H and
 *
 *     D/4 = b^2 - a c = r^2 H |Q|^2 - |P x Q|^2,   P x Q = (A x m) x (A x d) = (A.(m x d)) A,
 *         = H (r^2 |A x d|^2 - (A.(d x m))^2),
 *
 * which also says: the line is |A.(d x m)| / |A x d| away from the axis.
 *
 * a = 0 is a line along the axis: then Q = 0, b = 0, and the sign of c decides for the whole line.
 * The end planes keep 0 <= A.q <= H. Normals: -A/|A|, A/|A| and (q - (A.q / H) A) / r. */
#include "cgal_shape.h"

#include <algorithm>

namespace exact {

namespace {

class cylinder_question : public question {
public:
    cylinder_question(const line &on, const vector &base, const vector &top, const integer &radius)
        : question(on), m_(on.origin - base), axis_(top - base), radius_(radius),
          length_(square(axis_)), height_(dot(axis_, m_)), slope_(dot(axis_, on.direction)),
          wall_(make_wall())
    {
    }

    span chord() const override
    {
        return intersection(body(), slab(on_, height_, slope_, length_));
    }

    sure_part part(const real &t) const override
    {
        if (affine(height_, slope_, t).sign() == 0)
            return SURE_PART_BASE;
        if (affine(height_ - length_, slope_, t).sign() == 0)
            return SURE_PART_TOP;
        return SURE_PART_WALL;
    }

    unit_vector normal(const real &t) const override
    {
        switch (part(t)) {
        case SURE_PART_BASE:
            return unit(integer(-1) * axis_);
        case SURE_PART_TOP:
            return unit(axis_);
        default:
            return radius_.sign() == 0 ? unit(integer(-1) * on_.direction) : wall_normal(t);
        }
    }

    reference_decisions decisions() const override
    {
        reference_decisions signs = no_decisions();
        signs.leading = wall_.leading();
        signs.discriminant = wall_.discriminant();
        signs.axis = slope_.sign();
        decide_roots(wall_, on_, height_, slope_, length_, &signs);
        if (signs.axis != 0) {
            signs.base_cap = cap(m_, integer(0));
            signs.top_cap = cap(m_ - axis_, length_);
        }
        return signs;
    }

    const quadratic *wall() const override { return &wall_; }

private:
    quadratic make_wall() const
    {
        const vector &d = on_.direction;
        const integer a = length_ * square(d) - square(slope_);
        const integer b = length_ * dot(m_, d) - slope_ * height_;
        const integer c = length_ * (square(m_) - square(radius_)) - square(height_);
        const integer radicand = square(radius_) * square(cross(axis_, d)) -
                                 square(dot(axis_, cross(d, m_)));
        return quadratic(a, b, c, integer(1), length_ * radicand);
    }

    span body() const
    {
        if (wall_.leading() == 0)
            return wall_.c.sign() > 0 ? nothing() : everything(wall_.c.sign() < 0);
        if (wall_.discriminant() < 0)
            return nothing();
        return between(wall_.low_root(on_), wall_.high_root(on_), wall_.discriminant() > 0);
    }

    /* (H q - (A.q) A) / (H r) with q = m + tau d; H (m + tau d) - (A.m + tau A.d) A is affine in
     * tau. */
    unit_vector wall_normal(const real &t) const
    {
        const vector start = length_ * m_ - height_ * axis_;
        const vector slope = length_ * on_.direction - slope_ * axis_;
        return unit(affine(start, slope, t), surd(length_ * radius_ * t.denominator), surd(1));
    }

    int cap(const vector &from_centre, const integer &height) const
    {
        return distance_sign(from_centre, on_.direction, radius_,
                             on_.at(surd(integer(height - height_)), slope_));
    }

    vector m_, axis_;
    integer radius_, length_, height_, slope_;
    quadratic wall_;
};

sure_field check(const sure_object &object)
{
    const sure_cylinder &cylinder = object.as.cylinder;
    return check_radius(check_ends(cylinder.base, cylinder.top, SURE_FIELD_TOP), cylinder.radius);
}

std::unique_ptr<question> ask_cylinder(const sure_ray &ray, const sure_object &object)
{
    const sure_cylinder &cylinder = object.as.cylinder;
    common_unit length;
    length.show(ray.origin).show(cylinder.base).show(cylinder.top).show(cylinder.radius);
    return std::make_unique<cylinder_question>(make_line(ray, length), length.count(cylinder.base),
                                               length.count(cylinder.top),
                                               length.count(cylinder.radius));
}

std::vector<layer> layers(const sure_object &object)
{
    const kernel::Point_3 base = kernel_point(object.as.cylinder.base);
    const kernel::Point_3 top = kernel_point(object.as.cylinder.top);
    return {{base, top, top - base}};
}

rational surface(const sure_object &object, const kernel::Point_3 &p)
{
    const sure_cylinder &cylinder = object.as.cylinder;
    const kernel::Line_3 axis(kernel_point(cylinder.base), kernel_point(cylinder.top));
    return CGAL::squared_distance(axis.projection(p), p) - squared(cylinder.radius);
}

fields fields_of(const sure_object &object)
{
    const sure_cylinder &cylinder = object.as.cylinder;
    return {cylinder.base, cylinder.top, {}, cylinder.radius};
}

int side(const frame &object, const point &q, const integer &w)
{
    const integer reach = square(integer(object.radius * w));
    const surd across = square_of_cross(object.axis, q);
    return std::max(side_of_ends(object, dot(object.axis, q), w),
                    sign(across - integer(square(object.axis) * reach)));
}

/* The wall's gradient, halved, times w: of |A x q|^2 it is H q - (A.q) A. */
point way_out(const frame &object, const point &q, const integer &w)
{
    const integer length = square(object.axis);
    const surd along = dot(object.axis, q);
    if (sign(along - integer(length * w)) == 0)
        return times(object.axis, surd(1));
    if (sign(along) == 0)
        return times(object.axis, surd(-1));
    if (object.radius.sign() == 0)
        return times(object.on.direction, surd(-1));
    return minus(times(length, q), times(object.axis, along));
}

wall_frame frame_at(const sure_cylinder &cylinder, const sure_vec3 &p)
{
    return {cylinder.base, cylinder.top, cylinder.radius, p};
}

sure_vec3 normal_of_wall(const sure_object &object, const sure_vec3 &p)
{
    const wall_frame wall = frame_at(object.as.cylinder, p);
    const vector outward = square(wall.axis) * wall.q - dot(wall.axis, wall.q) * wall.axis;
    return square(outward).sign() == 0 ? sure_vec3{0, 0, 0} : nearest_vector(unit(outward));
}

bool within_height(const sure_object &object, const sure_vec3 &p)
{
    const wall_frame wall = frame_at(object.as.cylinder, p);
    const integer along = dot(wall.axis, wall.q);
    return along.sign() >= 0 && along <= square(wall.axis);
}

}

extern const shape_row cylinder_row = {check,   ask_cylinder,   where_capped, layers,
                                       surface, nullptr,        fields_of,    side,
                                       way_out, normal_of_wall, within_height};

}
