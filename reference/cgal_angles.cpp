/* SPDX-License-Identifier: MIT */
/* Rotation and field of view: MPFR's functions, enclosed from below and above, with more digits
 * until a comparison is settled. That ends, because no value is rational but in the cases answered
 * apart:
 *
 *   p cos(w) + q sin(w), w a double: with u = exp(i w) it is ((p - i q) u + (p + i q) / u) / 2.
 *   Were it algebraic, so would u be, but for w != 0 it is not (Lindemann), unless p = q = 0.
 *   tan(pi q), q rational, 0 < q < 1/2, is 1 at q = 1/4 and irrational elsewhere (Niven). */
#include "reference.h"

#include <mpfr.h>

#include "cgal_environment.h"
#include "cgal_exact.h"

using namespace exact;

namespace {

class digits {
public:
    explicit digits(mpfr_prec_t precision) { mpfr_init2(value, precision); }
    /* Holds x exactly. */
    explicit digits(const dyadic &x)
    {
        mpfr_init2(value, static_cast<mpfr_prec_t>(mpz_sizeinbase(x.mantissa.mpz(), 2) + 1));
        mpfr_set_z_2exp(value, x.mantissa.mpz(), x.exponent, MPFR_RNDN);
    }
    ~digits() { mpfr_clear(value); }
    digits(const digits &) = delete;
    digits &operator=(const digits &) = delete;

    mpfr_t value;
};

/* The bounds of a real number that some precision gives. */
struct bounds {
    explicit bounds(mpfr_prec_t precision) : low(precision), high(precision) {}
    digits low, high;
};

using enclosure = std::function<void(bounds *)>;

double cut(const digits &x)
{
    dyadic value = {integer(0), 0};
    if (!mpfr_zero_p(x.value))
        value.exponent = mpfr_get_z_2exp(value.mantissa.mpz(), x.value);
    return toward_zero(value);
}

/* A double next to the number: once both bounds agree on it, or nearly. */
double guess(const enclosure &enclose)
{
    for (mpfr_prec_t precision = 128;; precision *= 2) {
        bounds x(precision);
        enclose(&x);
        if (reference_ulps(cut(x.low), cut(x.high)) <= 1)
            return cut(x.low);
    }
}

double nearest_enclosed(const enclosure &enclose)
{
    return nearest(guess(enclose), [&enclose](const dyadic &y) {
        const digits middle(y);
        for (mpfr_prec_t precision = 128;; precision *= 2) {
            bounds x(precision);
            enclose(&x);
            if (mpfr_greater_p(x.low.value, middle.value))
                return 1;
            if (mpfr_less_p(x.high.value, middle.value))
                return -1;
        }
    });
}

/* Adds factor x to the sum. */
void add_multiple(const digits &factor, const bounds &x, bounds *sum)
{
    const bool turned = mpfr_sgn(factor.value) < 0;
    bounds product(mpfr_get_prec(sum->low.value));
    mpfr_mul(product.low.value, factor.value, turned ? x.high.value : x.low.value, MPFR_RNDD);
    mpfr_mul(product.high.value, factor.value, turned ? x.low.value : x.high.value, MPFR_RNDU);
    mpfr_add(sum->low.value, sum->low.value, product.low.value, MPFR_RNDD);
    mpfr_add(sum->high.value, sum->high.value, product.high.value, MPFR_RNDU);
}

/* p cos(angle) + q sin(angle). */
double nearest_turned(double angle, double p, double q)
{
    if (order_key(angle) == 0 || (order_key(p) == 0 && order_key(q) == 0))
        return from_order_key(order_key(p));
    const digits w(to_dyadic(angle)), along(to_dyadic(p)), across(to_dyadic(q));
    return nearest_enclosed([&](bounds *x) {
        bounds cosine(mpfr_get_prec(x->low.value)), sine(mpfr_get_prec(x->low.value));
        mpfr_cos(cosine.low.value, w.value, MPFR_RNDD);
        mpfr_cos(cosine.high.value, w.value, MPFR_RNDU);
        mpfr_sin(sine.low.value, w.value, MPFR_RNDD);
        mpfr_sin(sine.high.value, w.value, MPFR_RNDU);
        mpfr_set_zero(x->low.value, 1);
        mpfr_set_zero(x->high.value, 1);
        add_multiple(along, cosine, x);
        add_multiple(across, sine, x);
    });
}

double negated(double x)
{
    return from_order_key(-order_key(x));
}

}

extern "C" {

sure_vec3 reference_rotate(int axis, double angle, sure_vec3 v)
{
    const default_environment guard;
    const auto plus = [angle](double p, double q) { return nearest_turned(angle, p, q); };
    const auto minus = [angle](double p, double q) { return nearest_turned(angle, p, negated(q)); };
    switch (axis) {
    case 0:
        return {from_order_key(order_key(v.x)), minus(v.y, v.z), plus(v.z, v.y)};
    case 1:
        return {plus(v.x, v.z), from_order_key(order_key(v.y)), minus(v.z, v.x)};
    case 2:
        return {minus(v.x, v.y), plus(v.y, v.x), from_order_key(order_key(v.z))};
    default:
        contradiction("a rotation about no axis");
    }
}

/* tan(2 pi fov / 720). */
double reference_viewport_extent(double focal_length, double fov)
{
    const default_environment guard;
    dyadic twice = to_dyadic(focal_length);
    twice.exponent++;
    if (order_key(fov) == order_key(90.0))
        return nearest(real{surd(twice.mantissa), integer(1), twice.exponent});
    const digits factor(twice), degrees(to_dyadic(fov));
    return nearest_enclosed([&](bounds *x) {
        bounds tangent(mpfr_get_prec(x->low.value));
        mpfr_tanu(tangent.low.value, degrees.value, 720, MPFR_RNDD);
        mpfr_tanu(tangent.high.value, degrees.value, 720, MPFR_RNDU);
        mpfr_mul(x->low.value, factor.value, tangent.low.value, MPFR_RNDD);
        mpfr_mul(x->high.value, factor.value, tangent.high.value, MPFR_RNDU);
    });
}

}
