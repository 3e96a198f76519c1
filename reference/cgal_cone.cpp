/* SPDX-License-Identifier: MIT */
/* Cone. V the apex, q = P - V, A = base - V, H = A.A, m = o - V, P = o + tau d, s = A.q, r the
 * radius of the base. At s the axis point is s / H of the way to the base and the cone r s / H
 * wide; the axis is |A x q| / sqrt(H) away. So inside both nappes
 *
 *     F = H |A x q|^2 - r^2 (A.q)^2 = a tau^2 + 2 b tau + c <= 0,
 *     a = H |A x d|^2 - r^2 (A.d)^2,   b = H (A x m).(A x d) - r^2 (A.m)(A.d),
 *     c = H |A x m|^2 - r^2 (A.m)^2.
 *
 * Second derivation, by the notes' angle: q makes at most theta with A, cos^2 theta = H / (H +
 * r^2), so (A.q)^2 >= H q.q cos^2 theta, F = H^2 q.q - (H + r^2)(A.q)^2, and with K = H + r^2
 *
 *     a = H^2 d.d - K (A.d)^2,   b = H^2 m.d - K (A.m)(A.d),   c = H^2 m.m - K (A.m)^2.
 *
 * D/4 from the first form, with P = A x m, Q = A x d, p = A.m, s' = A.d:
 *     D/4 = (H P.Q - r^2 p s')^2 - (H |Q|^2 - r^2 s'^2)(H |P|^2 - r^2 p^2)
 *         = -H^2 |P x Q|^2 + H r^2 |p Q - s' P|^2,
 *     P x Q = (A.(m x d)) A,   p Q - s' P = A x (p d - s' m) = A x (A x (d x m)), so with w = d x m
 *     |P x Q|^2 = H (A.w)^2,   |p Q - s' P|^2 = H |A x w|^2 = H (H w.w - (A.w)^2), and
 *     D/4 = H^2 (r^2 H w.w - (H + r^2)(A.w)^2).
 * From the second form, with the quadratic form B(u, v) = H^2 u.v - K (A.u)(A.v), D/4 is minus the
 * Gram determinant of d and m, which is the adjugate of B at w: the eigenvalues of B are H^2 twice
 * across A and -r^2 H along it, so those of the adjugate are -r^2 H^3 twice and H^4 along A, and
 *     D/4 = r^2 H^3 (w.w - (A.w)^2 / H) - H^4 (A.w)^2 / H: the same.
 *
 * The kept nappe has s >= 0, the base plane keeps s <= H. Where the line meets F <= 0:
 *   a > 0  between the roots; connected, so on one nappe, or the apex alone;
 *   a < 0  before the low and after the high root. A.d = 0 would give a = H^2 d.d > 0, so s changes
 *          along the line, and F >= 0 where s = 0: one part on each nappe, and D/4 >= 0.
 *   a = 0  d lies along a generator. b != 0: a half-line. b = 0: m lies in the tangent plane of
 *          that generator, where F >= 0: the whole line if c = 0 (the generator's), else none.
 *
 * Normal: grad F / 2 = H^2 q - K s A; on the wall H^2 q.q = K s^2, so its square is K s^2 H^2 -
 * 2 K s^2 H^2 + K^2 s^2 H = K H r^2 s^2, its length r s sqrt(H K). Second derivation: across the
 * axis the unit normal has h / l, along the axis towards the apex r / l, with h = sqrt(H), l =
 * sqrt(K) the slant length; the direction across is (q - (s/H) A) / (r s / H), that towards the
 * apex -A / h. The sum, times r s h l: H^2 q - H s A - r^2 s A, the same. */
#include "cgal_shape.h"

#include <algorithm>

namespace exact {

namespace {

class cone_question : public question {
public:
    cone_question(const line &on, const vector &base, const vector &apex, const integer &radius)
        : question(on), m_(on.origin - apex), axis_(base - apex), radius_(radius),
          length_(square(axis_)), slant_(length_ + square(radius)), depth_(dot(axis_, m_)),
          slope_(dot(axis_, on.direction)), wall_(make_wall())
    {
    }

    span chord() const override { return intersection(body(), slab(on_, depth_, slope_, length_)); }

    sure_part part(const real &t) const override
    {
        return affine(depth_ - length_, slope_, t).sign() == 0 ? SURE_PART_BASE : SURE_PART_WALL;
    }

    unit_vector normal(const real &t) const override
    {
        if (part(t) == SURE_PART_BASE)
            return unit(axis_);
        const surd depth = affine(depth_, slope_, t);
        if (depth.sign() == 0)
            return unit(integer(-1) * axis_);
        if (radius_.sign() == 0)
            return unit(integer(-1) * on_.direction);
        const vector start = square(length_) * m_ - slant_ * depth_ * axis_;
        const vector slope = square(length_) * on_.direction - slant_ * slope_ * axis_;
        return unit(affine(start, slope, t), depth * radius_, surd(length_ * slant_));
    }

    reference_decisions decisions() const override
    {
        reference_decisions signs = no_decisions();
        signs.leading = wall_.leading();
        signs.discriminant = wall_.discriminant();
        signs.axis = -slope_.sign();
        decide_roots(wall_, on_, length_ - depth_, -slope_, length_, &signs);
        if (signs.axis != 0)
            signs.base_cap = distance_sign(m_ - axis_, on_.direction, radius_,
                                           on_.at(surd(integer(length_ - depth_)), slope_));
        return signs;
    }

    const quadratic *wall() const override { return &wall_; }

private:
    quadratic make_wall() const
    {
        const vector &d = on_.direction;
        const vector w = cross(d, m_);
        const integer a = square(length_) * square(d) - slant_ * square(slope_);
        const integer b = square(length_) * dot(m_, d) - slant_ * slope_ * depth_;
        const integer c = square(length_) * square(m_) - slant_ * square(depth_);
        const integer radicand = square(radius_) * length_ * square(w) -
                                 slant_ * square(dot(axis_, w));
        return quadratic(a, b, c, length_, radicand);
    }

    span body() const
    {
        switch (wall_.leading()) {
        case 1:
            if (wall_.discriminant() < 0)
                return nothing();
            return between(wall_.low_root(on_), wall_.high_root(on_), wall_.discriminant() > 0);
        case -1:
            return slope_.sign() > 0 ? from(wall_.high_root(on_)) : up_to(wall_.low_root(on_));
        default:
            if (wall_.b.sign() == 0)
                return wall_.c.sign() == 0 ? everything(false) : nothing();
            return wall_.b.sign() < 0 ? from(wall_.linear_root(on_))
                                      : up_to(wall_.linear_root(on_));
        }
    }

    static span from(const real &low) { return {false, true, low, std::nullopt}; }
    static span up_to(const real &high) { return {false, true, std::nullopt, high}; }

    vector m_, axis_;
    integer radius_, length_, slant_, depth_, slope_;
    quadratic wall_;
};

sure_field check(const sure_object &object)
{
    const sure_cone &cone = object.as.cone;
    return check_radius(check_ends(cone.base, cone.apex, SURE_FIELD_APEX), cone.radius);
}

std::unique_ptr<question> ask_cone(const sure_ray &ray, const sure_object &object)
{
    const sure_cone &cone = object.as.cone;
    common_unit length;
    length.show(ray.origin).show(cone.base).show(cone.apex).show(cone.radius);
    return std::make_unique<cone_question>(make_line(ray, length), length.count(cone.base),
                                           length.count(cone.apex), length.count(cone.radius));
}

std::vector<layer> layers(const sure_object &object)
{
    const kernel::Point_3 base = kernel_point(object.as.cone.base);
    const kernel::Point_3 apex = kernel_point(object.as.cone.apex);
    return {{base, apex, apex - base}};
}

/* At the foot's share of the way from apex to base the cone has that share of the radius. */
rational surface(const sure_object &object, const kernel::Point_3 &p)
{
    const sure_cone &cone = object.as.cone;
    const kernel::Point_3 apex = kernel_point(cone.apex), base = kernel_point(cone.base);
    const kernel::Point_3 foot = kernel::Line_3(apex, base).projection(p);
    const rational share_squared = CGAL::squared_distance(apex, foot) /
                                   CGAL::squared_distance(apex, base);
    return CGAL::squared_distance(foot, p) - share_squared * squared(cone.radius);
}

fields fields_of(const sure_object &object)
{
    return {object.as.cone.apex, object.as.cone.base, {}, object.as.cone.radius};
}

int side(const frame &object, const point &q, const integer &w)
{
    const surd along = dot(object.axis, q);
    const surd across = square_of_cross(object.axis, q);
    return std::max(side_of_ends(object, along, w),
                    sign(across * square(object.axis) - along * along * square(object.radius)));
}

/* The wall's gradient, halved, times w: of |A x q|^2 it is H q - (A.q) A, of (A.q)^2 it is
 * (A.q) A. */
point way_out(const frame &object, const point &q, const integer &w)
{
    const integer length = square(object.axis);
    const surd along = dot(object.axis, q);
    if (sign(along - integer(length * w)) == 0)
        return times(object.axis, surd(1)); /* the base */
    if (sign(along) == 0)
        return times(object.axis, surd(-1)); /* the apex */
    if (object.radius.sign() == 0)
        return times(object.on.direction, surd(-1));
    const point across = minus(times(length, q), times(object.axis, along));
    return minus(times(length, across), times(object.axis, along * square(object.radius)));
}

wall_frame frame_at(const sure_cone &cone, const sure_vec3 &p)
{
    return {cone.apex, cone.base, cone.radius, p};
}

/* P - S with S = Q + (|q| / cos(theta)) A/|A|, q = P - Q, A = base - Q, cos^2(theta) = H / (H +
 * r^2): H (P - S) = H q - A sqrt(X), X = q.q (H + r^2), and the square of that is H^2 q.q + H X
 * - 2 H (A.q) sqrt(X). */
unit_vector from_axis(const wall_frame &wall)
{
    const integer length = square(wall.axis);
    const integer under_root = square(wall.q) * (length + square(wall.radius));
    const auto component = [&](const integer &n, const integer &a) {
        return make_surd(length * n, -a, under_root);
    };
    const surd norm = make_surd(square(length) * square(wall.q) + length * under_root,
                                integer(-2) * length * dot(wall.axis, wall.q), under_root);
    return unit({component(wall.q.x, wall.axis.x), component(wall.q.y, wall.axis.y),
                 component(wall.q.z, wall.axis.z)},
                surd(1), norm);
}

sure_vec3 normal_of_wall(const sure_object &object, const sure_vec3 &p)
{
    const wall_frame wall = frame_at(object.as.cone, p);
    if (square(wall.q).sign() == 0)
        return nearest_vector(unit(integer(-1) * wall.axis));
    const unit_vector outward = from_axis(wall);
    return outward[0].radicand.sign() == 0 ? sure_vec3{0, 0, 0} : nearest_vector(outward);
}

bool within_height(const sure_object &object, const sure_vec3 &p)
{
    const wall_frame wall = frame_at(object.as.cone, p);
    return dot(wall.axis, wall.q).sign() >= 0 &&
           square(wall.q) <= square(wall.axis) + square(wall.radius);
}

}

extern const shape_row cone_row = {check,   ask_cone,       where_capped, layers,
                                   surface, nullptr,        fields_of,    side,
                                   way_out, normal_of_wall, within_height};

}
