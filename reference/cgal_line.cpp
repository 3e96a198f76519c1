/* SPDX-License-Identifier: MIT */
#include "cgal_line.h"

namespace exact {

real line::at(const surd &numerator, const integer &denominator) const
{
    switch (static_cast<int>(denominator.sign())) {
    case 1:
        return {numerator, denominator, exponent};
    case -1:
        return {-numerator, -denominator, exponent};
    default:
        contradiction("a division by zero");
    }
}

real line::at(const dyadic &t) const
{
    if (t.exponent >= exponent)
        return {surd(shifted_left(t.mantissa, t.exponent - exponent)), integer(1), exponent};
    return {surd(t.mantissa), shifted_left(integer(1), exponent - t.exponent), exponent};
}

line make_line(const sure_ray &ray, const common_unit &length)
{
    common_unit step;
    step.show(ray.direction);
    return {length.count(ray.origin), step.count(ray.direction),
            length.exponent() - step.exponent()};
}

quadratic::quadratic(const integer &a_, const integer &b_, const integer &c_, const integer &factor,
                     const integer &radicand)
    : a(a_), b(b_), c(c_), factor_(factor), radicand_(radicand)
{
    if (square(factor) * radicand != square(b) - a * c)
        contradiction("two derivations of D/4 differ");
}

real quadratic::root(const line &on, int sign_of_sqrt) const
{
    return on.at(make_surd(-b, factor_ * sign_of_sqrt, radicand_), a);
}

std::vector<real> quadratic::roots(const line &on) const
{
    if (a.sign() == 0)
        return b.sign() == 0 ? std::vector<real>{} : std::vector<real>{linear_root(on)};
    switch (discriminant()) {
    case -1:
        return {};
    case 0:
        return {low_root(on)};
    default:
        return {low_root(on), high_root(on)};
    }
}

span nothing()
{
    return {true, false, std::nullopt, std::nullopt};
}

span everything(bool solid)
{
    return {false, solid, std::nullopt, std::nullopt};
}

span between(const real &low, const real &high, bool solid)
{
    return {false, solid, low, high};
}

/* Open intervals have a point in common exactly when the higher low end is below the lower high
 * end. */
span intersection(const span &x, const span &y)
{
    if (x.empty || y.empty)
        return nothing();
    span both = {false, x.solid && y.solid, x.low, x.high};
    if (y.low && (!both.low || compare(*y.low, *both.low) > 0))
        both.low = y.low;
    if (y.high && (!both.high || compare(*y.high, *both.high) < 0))
        both.high = y.high;
    if (!both.low || !both.high)
        return both;
    const int order = compare(*both.low, *both.high);
    if (order > 0)
        return nothing();
    both.solid = both.solid && order < 0;
    return both;
}

span slab(const line &on, const integer &start, const integer &slope, const integer &length)
{
    if (slope.sign() == 0) {
        if (start.sign() < 0 || start > length)
            return nothing();
        return everything(start.sign() > 0 && start < length);
    }
    const real at_start = on.at(surd(-start), slope);
    const real at_length = on.at(surd(integer(length - start)), slope);
    return slope.sign() > 0 ? between(at_start, at_length, true)
                            : between(at_length, at_start, true);
}

unit_vector unit(const std::array<surd, 3> &numerators, const surd &factor, const surd &radicand)
{
    return {{{numerators[0], factor, radicand},
             {numerators[1], factor, radicand},
             {numerators[2], factor, radicand}}};
}

unit_vector unit(const vector &v)
{
    return unit({surd(v.x), surd(v.y), surd(v.z)}, surd(1), surd(square(v)));
}

surd affine(const integer &start, const integer &slope, const real &t)
{
    return t.numerator * slope + t.denominator * start;
}

std::array<surd, 3> affine(const vector &start, const vector &slope, const real &t)
{
    return {affine(start.x, slope.x, t), affine(start.y, slope.y, t), affine(start.z, slope.z, t)};
}

int distance_sign(const vector &m, const vector &d, const integer &radius, const real &tau)
{
    if (tau.numerator.is_extended())
        contradiction("a plane met at an irrational place");
    const vector from_centre = tau.denominator * m + tau.numerator.a0() * d;
    return (square(from_centre) - square(radius * tau.denominator)).sign();
}

reference_decisions no_decisions()
{
    const int none = REFERENCE_NONE;
    return {none, none, none, 0, {none, none}, {none, none}, none, none};
}

void decide_roots(const quadratic &wall, const line &on, const integer &start, const integer &slope,
                  const integer &length, reference_decisions *decisions)
{
    for (const real &root : wall.roots(on)) {
        const int i = decisions->roots++;
        decisions->base_side[i] = affine(start, slope, root).sign();
        decisions->top_side[i] = affine(start - length, slope, root).sign();
    }
}

}
