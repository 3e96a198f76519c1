/* SPDX-License-Identifier: MIT */
/* The shim's exact numbers: integers, numbers p + q sqrt(D), their comparison and their one
 * rounding to double. No floating-point operation takes part: doubles are read and made as bit
 * patterns, so neither rounding mode nor flush-to-zero can matter. */
#ifndef REFERENCE_CGAL_EXACT_H
#define REFERENCE_CGAL_EXACT_H

#include <climits>
#include <cstdint>
#include <functional>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Sqrt_extension.h>

#include <surehit/vector.h>

namespace exact {

using integer = CGAL::Gmpz;
using rational = CGAL::Gmpq;

/* p + q sqrt(D). Only its ring operations, between numbers of one root, and sign() are used. */
using surd = CGAL::Sqrt_extension<integer, integer>;

/* x + y sqrt(v) of surds: two roots in one expression. Only sign() is used. */
using tower = CGAL::Sqrt_extension<surd, surd>;

/* CGAL takes 0 + q sqrt(0) for q, so a root of zero must never reach it. */
surd make_surd(const integer &p, const integer &q, const integer &root);

/* Ends the program: an oracle that contradicts itself must not answer. */
[[noreturn]] void contradiction(const char *what);

/* mantissa * 2^exponent. */
struct dyadic {
    integer mantissa;
    long exponent;
};

dyadic operator+(const dyadic &x, const dyadic &y);
dyadic operator-(const dyadic &x, const dyadic &y);
rational to_rational(const dyadic &x);
integer shifted_left(const integer &n, long bits);

/* Doubles in their order, one apart: -0 and +0 are 0, infinities follow the largest finite ones.
 * The double must not be a NaN. */
int64_t order_key(double x);
double from_order_key(int64_t key);
bool is_nan(double x);
bool is_finite(double x);

/* The exact value of a finite double, with an odd mantissa or zero; an infinity gives +-2^1024, its
 * place in rounding. */
dyadic to_dyadic(double x);

/* Cut to 53 bits, or to what a subnormal has; from 2^1024 on an infinity. */
double toward_zero(const dyadic &x);

/* numerator / denominator * 2^exponent, denominator > 0. */
struct real {
    surd numerator;
    integer denominator;
    long exponent;
};

int sign(const real &x);
int compare(const real &x, const real &y);
int compare(const real &x, const dyadic &y);
double nearest(const real &x);

/* numerator / (factor * sqrt(radicand)), factor and radicand > 0, all of one root: a component
 * of a unit vector. */
struct unit_component {
    surd numerator, factor, radicand;
};

int compare(const unit_component &x, const dyadic &y);
double nearest(const unit_component &x);

/* The double nearest to the real number of which sign_against tells the sign of its difference from
 * any dyadic. The guess is one of the doubles around it, or next to one. */
double nearest(double guess, const std::function<int(const dyadic &)> &sign_against);

struct vector {
    integer x, y, z;
};

vector operator+(const vector &u, const vector &v);
vector operator-(const vector &u, const vector &v);
vector operator*(const integer &k, const vector &v);
integer dot(const vector &u, const vector &v);
vector cross(const vector &u, const vector &v);
inline integer square(const integer &n) { return n * n; }
inline integer square(const vector &v) { return dot(v, v); }

/* A power of two of which every double shown to it is a multiple; doubles become integers by it. */
class common_unit {
public:
    common_unit &show(double x);
    common_unit &show(const sure_vec3 &v) { return show(v.x).show(v.y).show(v.z); }
    long exponent() const { return lowest_ == LONG_MAX ? 0 : lowest_; }
    integer count(double x) const;
    vector count(const sure_vec3 &v) const { return {count(v.x), count(v.y), count(v.z)}; }

private:
    long lowest_ = LONG_MAX;
};

/* A vector in its own unit, which does not matter. */
inline vector count_alone(const sure_vec3 &v) { return common_unit().show(v).count(v); }

}

#endif
