/* SPDX-License-Identifier: MIT */
/* What the shapes share: the ray's line in integers, the parts of it that an inequality leaves,
 * and the questions that every shape answers about the two of them. */
#ifndef REFERENCE_CGAL_LINE_H
#define REFERENCE_CGAL_LINE_H

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "cgal_exact.h"
#include "reference.h"

namespace exact {

/* The points origin + tau direction in units of their own; the ray's t is tau * 2^exponent. */
struct line {
    vector origin, direction;
    long exponent;

    real at(const surd &numerator, const integer &denominator) const;
    real at(const dyadic &t) const;
};

line make_line(const sure_ray &ray, const common_unit &length);

/* a tau^2 + 2 b tau + c; D/4 = b^2 - a c is given as factor^2 radicand, found another way, with
 * factor > 0: the two are held against each other. */
class quadratic {
public:
    quadratic(const integer &a, const integer &b, const integer &c, const integer &factor,
              const integer &radicand);

    int leading() const { return a.sign(); }
    int discriminant() const { return radicand_.sign(); }
    /* (-b -+ sqrt(D/4)) / a in the order of their values. Entry: a != 0, D/4 >= 0. */
    real low_root(const line &on) const { return root(on, a.sign() > 0 ? -1 : 1); }
    real high_root(const line &on) const { return root(on, a.sign() > 0 ? 1 : -1); }
    /* -c / 2b. Entry: a = 0, b != 0. */
    real linear_root(const line &on) const { return on.at(surd(-c), b + b); }
    /* All of them in order, a double one once; none where all three coefficients are zero. */
    std::vector<real> roots(const line &on) const;
    bool vanishes() const { return a.sign() == 0 && b.sign() == 0 && c.sign() == 0; }

    const integer a, b, c;

private:
    real root(const line &on, int sign_of_sqrt) const;

    integer factor_, radicand_;
};

/* A convex part of the line: its closed points from low to high (absent: without end). `solid`
 * tells whether it has points where every inequality behind it is strict. */
struct span {
    bool empty;
    bool solid;
    std::optional<real> low, high;
};

span nothing();
span everything(bool solid);
span between(const real &low, const real &high, bool solid);
span intersection(const span &x, const span &y);

/* Where 0 <= start + tau slope <= length. */
span slab(const line &on, const integer &start, const integer &slope, const integer &length);

/* |m + tau d|^2 - r^2. */
quadratic sphere_quadratic(const vector &m, const vector &d, const integer &radius);

using unit_vector = std::array<unit_component, 3>;

/* One line and one object. */
class question {
public:
    explicit question(const line &on) : on_(on) {}
    virtual ~question() = default;

    /* The chord: solid when the line meets the object's interior. */
    virtual span chord() const = 0;
    virtual sure_part part(const real &t) const = 0;
    /* The outward unit normal at a hit. */
    virtual unit_vector normal(const real &t) const = 0;
    virtual reference_decisions decisions() const = 0;
    /* The endless wall's quadratic; absent where there is none. */
    virtual const quadratic *wall() const { return nullptr; }
    const line &on() const { return on_; }

protected:
    const line on_;
};

/* Entry: valid ray and object. */
std::unique_ptr<question> ask(const sure_ray &ray, const sure_object &object);

/* v/|v|. Entry: v != 0. */
unit_vector unit(const vector &v);
unit_vector unit(const std::array<surd, 3> &numerators, const surd &factor, const surd &radicand);

/* start + slope tau times t's denominator: its sign is that of the affine function at t. */
surd affine(const integer &start, const integer &slope, const real &t);
std::array<surd, 3> affine(const vector &start, const vector &slope, const real &t);

/* Sign of |m + tau d|^2 - r^2 at tau. Entry: tau rational. */
int distance_sign(const vector &m, const vector &d, const integer &radius, const real &tau);

reference_decisions no_decisions();

/* Writes the roots of a wall and on which side of base and top they are; their height above the
 * base is start + slope tau, in [0, length] between the two. */
void decide_roots(const quadratic &wall, const line &on, const integer &start, const integer &slope,
                  const integer &length, reference_decisions *decisions);

}

#endif
