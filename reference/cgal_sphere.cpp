/* SPDX-License-Identifier: MIT */
/* Sphere. For P = o + tau d, m = o - C, |P - C|^2 - r^2 = a tau^2 + 2 b tau + c with
 *
 *     a = d.d,   b = m.d,   c = m.m - r^2,   D/4 = b^2 - a c.
 *
 * Second derivation: the line is |d x m| / |d| away from C and cuts half a chord of sqrt(r^2 - |d x
 * m|^2 / |d|^2) on both sides of the foot of C at tau = -m.d / d.d, and a length is |d| times its
 * tau. So tau = (-m.d -+ sqrt(r^2 d.d - |d x m|^2)) / d.d and
 *
 *     D/4 = r^2 d.d - |d x m|^2.                           (Lagrange's identity says the same)
 *
 * Interior points exist on the line when D/4 > 0; with r = 0 it never is. Normal: (m + tau d) /
 * r. */
#include "cgal_shape.h"

namespace exact {

quadratic sphere_quadratic(const vector &m, const vector &d, const integer &radius)
{
    return quadratic(square(d), dot(m, d), square(m) - square(radius), integer(1),
                     square(radius) * square(d) - square(cross(d, m)));
}

namespace {

class sphere_question : public question {
public:
    sphere_question(const line &on, const vector &centre, const integer &radius)
        : question(on), m_(on.origin - centre), radius_(radius),
          surface_(sphere_quadratic(m_, on.direction, radius))
    {
    }

    span chord() const override
    {
        if (surface_.discriminant() < 0)
            return nothing();
        return between(surface_.low_root(on_), surface_.high_root(on_),
                       surface_.discriminant() > 0);
    }

    sure_part part(const real &) const override { return SURE_PART_SURFACE; }

    unit_vector normal(const real &t) const override
    {
        if (radius_.sign() == 0)
            return unit(integer(-1) * on_.direction);
        return unit(affine(m_, on_.direction, t), surd(radius_ * t.denominator), surd(1));
    }

    reference_decisions decisions() const override
    {
        reference_decisions signs = no_decisions();
        signs.leading = surface_.leading();
        signs.discriminant = surface_.discriminant();
        signs.roots = signs.discriminant + 1;
        return signs;
    }

private:
    vector m_;
    integer radius_;
    quadratic surface_;
};

sure_field check(const sure_object &object)
{
    const bool valid = finite(object.as.sphere.centre);
    return check_radius(valid ? SURE_FIELD_NONE : SURE_FIELD_CENTRE, object.as.sphere.radius);
}

std::unique_ptr<question> ask_sphere(const sure_ray &ray, const sure_object &object)
{
    const sure_sphere &sphere = object.as.sphere;
    common_unit length;
    length.show(ray.origin).show(sphere.centre).show(sphere.radius);
    return std::make_unique<sphere_question>(make_line(ray, length), length.count(sphere.centre),
                                             length.count(sphere.radius));
}

/* Sphere_3 takes the squared radius: it is squared here, exactly. */
int where(const sure_object &object, const kernel::Point_3 &p)
{
    const kernel::Sphere_3 ball(kernel_point(object.as.sphere.centre),
                                squared(object.as.sphere.radius));
    return -ball.bounded_side(p);
}

std::vector<layer> layers(const sure_object &)
{
    return {};
}

rational surface(const sure_object &object, const kernel::Point_3 &p)
{
    return CGAL::squared_distance(kernel_point(object.as.sphere.centre), p) -
           squared(object.as.sphere.radius);
}

common_points meet(const sure_object &object, const kernel::Line_3 &)
{
    return {false,
            {},
            common_points::ball{kernel_point(object.as.sphere.centre),
                                squared(object.as.sphere.radius)}};
}

fields fields_of(const sure_object &object)
{
    return {object.as.sphere.centre, {}, {}, object.as.sphere.radius};
}

int side(const frame &object, const point &q, const integer &w)
{
    return sign(square(q) - square(integer(object.radius * w)));
}

point way_out(const frame &object, const point &q, const integer &)
{
    return object.radius.sign() == 0 ? times(object.on.direction, surd(-1)) : q;
}

}

extern const shape_row sphere_row = {check,     ask_sphere, where,   layers,  surface, meet,
                                     fields_of, side,       way_out, nullptr, nullptr};

}
