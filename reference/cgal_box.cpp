/* SPDX-License-Identifier: MIT */
/* Box. For P = o + tau d and an axis i, the point is between the planes through the corners L and H
 * where
 *
 *     0 <= (o - L)_i + tau d_i <= (H - L)_i,
 *
 * and in the box where it is so for all three. Second derivation, by the definition: a point is
 * outside when a coordinate is beyond that of a corner, and on the boundary when none is and one is
 * equal. Interior points exist when the line is strictly between all planes somewhere. The normal
 * is the axis of the first face, -x, x, -y, ..., that the point is on. */
#include "cgal_shape.h"

#include <algorithm>
#include <array>

namespace exact {

namespace {

std::array<integer, 3> coordinates(const vector &v)
{
    return {v.x, v.y, v.z};
}

/* The unit vector of an axis, or its opposite. */
vector axis_of(int i, int sign)
{
    const std::array<integer, 3> v = {integer(i == 0 ? sign : 0), integer(i == 1 ? sign : 0),
                                      integer(i == 2 ? sign : 0)};
    return {v[0], v[1], v[2]};
}

class box_question : public question {
public:
    box_question(const line &on, const vector &low, const vector &high)
        : question(on), start_(coordinates(on.origin - low)), slope_(coordinates(on.direction)),
          length_(coordinates(high - low))
    {
    }

    span chord() const override
    {
        span all = everything(true);
        for (std::size_t i = 0; i < 3; i++)
            all = intersection(all, slab(on_, start_[i], slope_[i], length_[i]));
        return all;
    }

    sure_part part(const real &t) const override
    {
        return static_cast<sure_part>(SURE_PART_X_MIN + face(t));
    }

    unit_vector normal(const real &t) const override
    {
        const int at = face(t);
        return unit(axis_of(at / 2, at % 2 == 0 ? -1 : 1));
    }

    reference_decisions decisions() const override { return no_decisions(); }

private:
    int face(const real &t) const
    {
        for (int i = 0; i < 3; i++) {
            if (affine(start_[i], slope_[i], t).sign() == 0)
                return 2 * i;
            if (affine(start_[i] - length_[i], slope_[i], t).sign() == 0)
                return 2 * i + 1;
        }
        contradiction("a point on no face of its box");
    }

    std::array<integer, 3> start_, slope_, length_;
};

bool above(double high, double low)
{
    return order_key(high) >= order_key(low);
}

sure_field check(const sure_object &object)
{
    const sure_vec3 &low = object.as.box.low, &high = object.as.box.high;
    if (!finite(low))
        return SURE_FIELD_LOW;
    return finite(high) && above(high.x, low.x) && above(high.y, low.y) && above(high.z, low.z)
               ? SURE_FIELD_NONE
               : SURE_FIELD_HIGH;
}

std::unique_ptr<question> ask_box(const sure_ray &ray, const sure_object &object)
{
    const sure_box &box = object.as.box;
    common_unit length;
    length.show(ray.origin).show(box.low).show(box.high);
    return std::make_unique<box_question>(make_line(ray, length), length.count(box.low),
                                          length.count(box.high));
}

int where(const sure_object &object, const kernel::Point_3 &p)
{
    const kernel::Point_3 low = kernel_point(object.as.box.low);
    const kernel::Point_3 high = kernel_point(object.as.box.high);
    return -kernel::Iso_cuboid_3(low, high).bounded_side(p);
}

std::vector<layer> layers(const sure_object &object)
{
    const kernel::Point_3 low = kernel_point(object.as.box.low);
    const kernel::Point_3 high = kernel_point(object.as.box.high);
    return {{low, high, {1, 0, 0}}, {low, high, {0, 1, 0}}, {low, high, {0, 0, 1}}};
}

fields fields_of(const sure_object &object)
{
    return {object.as.box.low, object.as.box.high, {}, 0};
}

int side(const frame &object, const point &q, const integer &w)
{
    const std::array<integer, 3> length = coordinates(object.axis);
    int most = -1;
    for (std::size_t i = 0; i < 3; i++)
        most = std::max({most, sign(-q[i]), sign(q[i] - integer(length[i] * w))});
    return most;
}

point way_out(const frame &object, const point &q, const integer &w)
{
    const std::array<integer, 3> length = coordinates(object.axis);
    for (int i = 0; i < 3; i++) {
        if (sign(q[i]) == 0)
            return times(axis_of(i, -1), surd(1));
        if (sign(q[i] - integer(length[i] * w)) == 0)
            return times(axis_of(i, 1), surd(1));
    }
    contradiction("a point on no face of its box");
}

}

extern const shape_row box_row = {check,     ask_box, where,   layers,  nullptr, nullptr,
                                  fields_of, side,    way_out, nullptr, nullptr};

}
