/* SPDX-License-Identifier: MIT */
#include "cgal_exact.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <mpfr.h>

namespace exact {

[[noreturn]] void contradiction(const char *what)
{
    std::fprintf(stderr, "reference: contradiction: %s\n", what);
    std::abort();
}

surd make_surd(const integer &p, const integer &q, const integer &root)
{
    if (root.sign() < 0)
        contradiction("the root of a negative number");
    if (q.sign() == 0 || root.sign() == 0)
        return surd(p);
    return surd(p, q, root);
}

integer shifted_left(const integer &n, long bits)
{
    integer shifted;
    mpz_mul_2exp(shifted.mpz(), n.mpz(), static_cast<mp_bitcnt_t>(bits));
    return shifted;
}

static surd shifted_left(const surd &x, long bits)
{
    if (!x.is_extended())
        return surd(shifted_left(x.a0(), bits));
    return surd(shifted_left(x.a0(), bits), shifted_left(x.a1(), bits), x.root());
}

dyadic operator+(const dyadic &x, const dyadic &y)
{
    const long low = std::min(x.exponent, y.exponent);
    return {shifted_left(x.mantissa, x.exponent - low) + shifted_left(y.mantissa, y.exponent - low),
            low};
}

dyadic operator-(const dyadic &x, const dyadic &y)
{
    return x + dyadic{-y.mantissa, y.exponent};
}

rational to_rational(const dyadic &x)
{
    if (x.exponent >= 0)
        return rational(shifted_left(x.mantissa, x.exponent));
    return rational(x.mantissa, shifted_left(integer(1), -x.exponent));
}

static const uint64_t SIGN_BIT = UINT64_C(1) << 63;
static const int64_t INFINITE_KEY = INT64_C(0x7ff) << 52;

static uint64_t bits_of(double x)
{
    uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

static int64_t magnitude_of(double x)
{
    return static_cast<int64_t>(bits_of(x) & ~SIGN_BIT);
}

int64_t order_key(double x)
{
    return bits_of(x) & SIGN_BIT ? -magnitude_of(x) : magnitude_of(x);
}

double from_order_key(int64_t key)
{
    const uint64_t bits = key < 0 ? static_cast<uint64_t>(-key) | SIGN_BIT
                                  : static_cast<uint64_t>(key);
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

bool is_nan(double x)
{
    return magnitude_of(x) > INFINITE_KEY;
}

bool is_finite(double x)
{
    return magnitude_of(x) < INFINITE_KEY;
}

/* The format of binary64: mantissa and exponent of the double of a key >= 0. The key of
 * infinity gives 2^1024, its place in rounding. */
static int64_t key_mantissa(int64_t key)
{
    const int64_t field = key & ((INT64_C(1) << 52) - 1);
    return key >> 52 == 0 ? field : field | INT64_C(1) << 52;
}

static long key_exponent(int64_t key)
{
    return key >> 52 == 0 ? -1074 : static_cast<long>(key >> 52) - 1075;
}

dyadic to_dyadic(double x)
{
    const int64_t magnitude = magnitude_of(x);
    int64_t mantissa = key_mantissa(magnitude);
    if (mantissa == 0)
        return {integer(0), 0};
    const int zeros = __builtin_ctzll(static_cast<unsigned long long>(mantissa));
    mantissa >>= zeros;
    return {integer(static_cast<long>(bits_of(x) & SIGN_BIT ? -mantissa : mantissa)),
            key_exponent(magnitude) + zeros};
}

/* Halfway between the double of the key and the next one: within a binade and across its upper
 * end the spacing is that of the lower of the two. */
static dyadic midpoint_above(int64_t key)
{
    if (key < 0) {
        const dyadic mirrored = midpoint_above(-key - 1);
        return {-mirrored.mantissa, mirrored.exponent};
    }
    return {integer(static_cast<long>(2 * key_mantissa(key) + 1)), key_exponent(key) - 1};
}

double nearest(double guess, const std::function<int(const dyadic &)> &sign_against)
{
    int64_t key = order_key(guess);
    const auto rounds_up = [&] {
        const int side = key < INFINITE_KEY ? sign_against(midpoint_above(key)) : -1;
        return side > 0 || (side == 0 && key % 2 != 0);
    };
    const auto rounds_down = [&] {
        const int side = key > -INFINITE_KEY ? sign_against(midpoint_above(key - 1)) : 1;
        return side < 0 || (side == 0 && key % 2 != 0);
    };
    for (int step = 0; step < 4; step++) {
        if (rounds_up())
            key++;
        else if (rounds_down())
            key--;
        else
            return from_order_key(key);
    }
    contradiction("a guess that is no double's neighbour");
}

double toward_zero(const dyadic &x)
{
    const long length = static_cast<long>(mpz_sizeinbase(x.mantissa.mpz(), 2));
    const long leading = x.exponent + length - 1;
    if (x.mantissa.sign() == 0 || leading < -1074)
        return from_order_key(0);
    const bool negative = x.mantissa.sign() < 0;
    if (leading > 1023)
        return from_order_key(negative ? -INFINITE_KEY : INFINITE_KEY);
    const long kept = std::min(53L, leading + 1075);
    integer digits = shifted_left(x.mantissa, std::max(0L, kept - length));
    mpz_tdiv_q_2exp(digits.mpz(), digits.mpz(),
                    static_cast<mp_bitcnt_t>(std::max(0L, length - kept)));
    int64_t key = static_cast<int64_t>(mpz_get_ui(digits.mpz()));
    if (leading >= -1022)
        key += (leading + 1022) * (INT64_C(1) << 52); /* the leading bit adds the last binade */
    return from_order_key(negative ? -key : key);
}

/* p + q sqrt(D) and quotients of such, to about 120 bits: a guess for nearest(). */
class estimate {
public:
    estimate() { mpfr_init2(value_, 128); }
    explicit estimate(const integer &n) : estimate() { mpfr_set_z(value_, n.mpz(), MPFR_RNDN); }
    explicit estimate(const surd &x);
    estimate(const estimate &) = delete;
    estimate &operator=(const estimate &) = delete;
    ~estimate() { mpfr_clear(value_); }

    /* Times 2^exponent, to 53 bits. */
    double near(long exponent);

    mpfr_t value_;
};

/* Where p and q sqrt(D) nearly cancel, (p^2 - q^2 D) / (p - q sqrt(D)) keeps the digits. */
estimate::estimate(const surd &x) : estimate(x.a0())
{
    if (!x.is_extended())
        return;
    estimate root(x.root()), factor(x.a1());
    mpfr_sqrt(root.value_, root.value_, MPFR_RNDN);
    mpfr_mul(root.value_, root.value_, factor.value_, MPFR_RNDN);
    if (x.a0().sign() * x.a1().sign() >= 0) {
        mpfr_add(value_, value_, root.value_, MPFR_RNDN);
        return;
    }
    const estimate norm(square(x.a0()) - square(x.a1()) * x.root());
    mpfr_sub(value_, value_, root.value_, MPFR_RNDN);
    mpfr_div(value_, norm.value_, value_, MPFR_RNDN);
}

double estimate::near(long exponent)
{
    mpfr_prec_round(value_, 53, MPFR_RNDN);
    dyadic x = {integer(0), 0};
    if (!mpfr_zero_p(value_))
        x.exponent = exponent + mpfr_get_z_2exp(x.mantissa.mpz(), value_);
    return toward_zero(x);
}

int sign(const real &x)
{
    return x.numerator.sign();
}

static bool one_root(const surd &x, const surd &y)
{
    return !x.is_extended() || !y.is_extended() || x.root() == y.root();
}

int compare(const real &x, const real &y)
{
    const long low = std::min(x.exponent, y.exponent);
    const surd left = shifted_left(x.numerator, x.exponent - low) * y.denominator;
    const surd right = shifted_left(y.numerator, y.exponent - low) * x.denominator;
    if (one_root(left, right))
        return surd(left - right).sign();
    return tower(left - right.a0(), surd(-right.a1()), surd(right.root())).sign();
}

int compare(const real &x, const dyadic &y)
{
    const long low = std::min(x.exponent, y.exponent);
    const integer scaled = shifted_left(y.mantissa, y.exponent - low) * x.denominator;
    return surd(shifted_left(x.numerator, x.exponent - low) - scaled).sign();
}

double nearest(const real &x)
{
    if (sign(x) == 0)
        return from_order_key(0);
    estimate guess(x.numerator);
    const estimate denominator(x.denominator);
    mpfr_div(guess.value_, guess.value_, denominator.value_, MPFR_RNDN);
    return nearest(guess.near(x.exponent),
                   [&x](const dyadic &y) { return compare(x, y); });
}

int compare(const unit_component &x, const dyadic &y)
{
    const surd numerator = y.exponent < 0 ? shifted_left(x.numerator, -y.exponent) : x.numerator;
    const integer mantissa = y.exponent > 0 ? shifted_left(y.mantissa, y.exponent) : y.mantissa;
    return tower(numerator, x.factor * -mantissa, x.radicand).sign();
}

double nearest(const unit_component &x)
{
    if (x.numerator.sign() == 0)
        return from_order_key(0);
    estimate guess(x.numerator), root(x.radicand);
    const estimate factor(x.factor);
    mpfr_sqrt(root.value_, root.value_, MPFR_RNDN);
    mpfr_div(guess.value_, guess.value_, root.value_, MPFR_RNDN);
    mpfr_div(guess.value_, guess.value_, factor.value_, MPFR_RNDN);
    return nearest(guess.near(0), [&x](const dyadic &y) { return compare(x, y); });
}

vector operator+(const vector &u, const vector &v)
{
    return {u.x + v.x, u.y + v.y, u.z + v.z};
}

vector operator-(const vector &u, const vector &v)
{
    return {u.x - v.x, u.y - v.y, u.z - v.z};
}

vector operator*(const integer &k, const vector &v)
{
    return {k * v.x, k * v.y, k * v.z};
}

integer dot(const vector &u, const vector &v)
{
    return u.x * v.x + u.y * v.y + u.z * v.z;
}

vector cross(const vector &u, const vector &v)
{
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

common_unit &common_unit::show(double x)
{
    const dyadic value = to_dyadic(x);
    if (value.mantissa.sign() != 0)
        lowest_ = std::min(lowest_, value.exponent);
    return *this;
}

integer common_unit::count(double x) const
{
    const dyadic value = to_dyadic(x);
    if (value.mantissa.sign() == 0)
        return integer(0);
    return shifted_left(value.mantissa, value.exponent - lowest_);
}

}
