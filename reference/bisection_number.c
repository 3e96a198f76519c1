/* SPDX-License-Identifier: MIT */
#include "bisection_number.h"

#include <stddef.h>
#include <string.h>

#define FRACTION_BITS 52
#define SMALLEST_EXPONENT (-1074) /* of the last place of a subnormal */

uint64_t double_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

double double_from_bits(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

bool double_is_finite(double value)
{
    return (double_bits(value) & ~SIGN_BIT) < INFINITY_BITS;
}

bool double_is_zero(double value)
{
    return (double_bits(value) & ~SIGN_BIT) == 0;
}

/* The magnitude with these bits is the returned integer times 2^exponent. The bits of infinity
 * stand for 2^1024, the value that would come next. */
static uint64_t magnitude(uint64_t bits, long *exponent)
{
    const uint64_t hidden_bit = UINT64_C(1) << FRACTION_BITS;
    uint64_t fraction_part = bits & (hidden_bit - 1);
    long biased = (long)(bits >> FRACTION_BITS);
    *exponent = SMALLEST_EXPONENT + (biased > 0 ? biased - 1 : 0);
    return biased > 0 ? fraction_part | hidden_bit : fraction_part;
}

uint64_t double_split(double value, long *exponent)
{
    uint64_t mantissa = magnitude(double_bits(value) & ~SIGN_BIT, exponent);
    if (mantissa == 0)
        *exponent = 0;
    while (mantissa != 0 && mantissa % 2 == 0) {
        mantissa /= 2;
        ++*exponent;
    }
    return mantissa;
}

static void set_uint64(mpz_t out, uint64_t value)
{
    mpz_import(out, 1, 1, sizeof value, 0, 0, &value);
}

void integer_from(mpz_t out, double value, long exponent)
{
    long own_exponent;
    set_uint64(out, double_split(value, &own_exponent));
    if (mpz_sgn(out) != 0)
        mpz_mul_2exp(out, out, (mp_bitcnt_t)(own_exponent - exponent));
    if (double_bits(value) & SIGN_BIT)
        mpz_neg(out, out);
}

void fraction_init(fraction *x)
{
    mpz_init(x->num);
    mpz_init_set_ui(x->den, 1);
}

void fraction_clear(fraction *x)
{
    mpz_clears(x->num, x->den, (mpz_ptr)NULL);
}

void fraction_set(fraction *x, const fraction *y)
{
    mpz_set(x->num, y->num);
    mpz_set(x->den, y->den);
}

void fraction_set_integer(fraction *x, long value)
{
    mpz_set_si(x->num, value);
    mpz_set_ui(x->den, 1);
}

/* x = mantissa * 2^exponent */
static void set_scaled(fraction *x, uint64_t mantissa, long exponent)
{
    set_uint64(x->num, mantissa);
    mpz_set_ui(x->den, 1);
    if (exponent > 0)
        mpz_mul_2exp(x->num, x->num, (mp_bitcnt_t)exponent);
    else
        mpz_mul_2exp(x->den, x->den, (mp_bitcnt_t)-exponent);
}

void fraction_set_double(fraction *x, double value)
{
    long exponent;
    uint64_t mantissa = double_split(value, &exponent);
    set_scaled(x, mantissa, exponent);
    if (double_bits(value) & SIGN_BIT)
        mpz_neg(x->num, x->num);
}

void fraction_set_quotient(fraction *x, const mpz_t num, const mpz_t den)
{
    int sign = mpz_sgn(den);
    mpz_set(x->num, num);
    mpz_abs(x->den, den);
    if (sign < 0)
        mpz_neg(x->num, x->num);
}

int fraction_compare(const fraction *x, const fraction *y)
{
    int sign_x = mpz_sgn(x->num), sign_y = mpz_sgn(y->num);
    if (sign_x != sign_y)
        return sign_x < sign_y ? -1 : 1;
    mpz_t left, right;
    mpz_inits(left, right, (mpz_ptr)NULL);
    mpz_mul(left, x->num, y->den);
    mpz_mul(right, y->num, x->den);
    int order = mpz_cmp(left, right);
    mpz_clears(left, right, (mpz_ptr)NULL);
    return (order > 0) - (order < 0);
}

void polynomial_init(polynomial *p)
{
    mpz_inits(p->term[0], p->term[1], p->term[2], (mpz_ptr)NULL);
}

void polynomial_clear(polynomial *p)
{
    mpz_clears(p->term[0], p->term[1], p->term[2], (mpz_ptr)NULL);
}

static void polynomial_set(polynomial *p, const polynomial *q)
{
    for (int i = 0; i < 3; i++)
        mpz_set(p->term[i], q->term[i]);
}

/* p(num/den) has the sign of (term2 num + term1 den) num + term0 den^2, since den > 0. */
int polynomial_sign(const polynomial *p, const fraction *t)
{
    mpz_t value, product;
    mpz_inits(value, product, (mpz_ptr)NULL);
    mpz_mul(value, p->term[2], t->num);
    mpz_addmul(value, p->term[1], t->den);
    mpz_mul(value, value, t->num);
    mpz_mul(product, p->term[0], t->den);
    mpz_addmul(value, product, t->den);
    int sign = mpz_sgn(value);
    mpz_clears(value, product, (mpz_ptr)NULL);
    return sign;
}

void location_init(location *x)
{
    x->exact = true;
    fraction_init(&x->low);
    fraction_init(&x->high);
    polynomial_init(&x->curve);
    x->sign_low = 0;
}

void location_clear(location *x)
{
    fraction_clear(&x->low);
    fraction_clear(&x->high);
    polynomial_clear(&x->curve);
}

void location_set(location *x, const location *y)
{
    x->exact = y->exact;
    fraction_set(&x->low, &y->low);
    if (!y->exact) {
        fraction_set(&x->high, &y->high);
        polynomial_set(&x->curve, &y->curve);
        x->sign_low = y->sign_low;
    }
}

void location_set_fraction(location *x, const fraction *value)
{
    x->exact = true;
    fraction_set(&x->low, value);
}

static void set_linear_root(fraction *root, const mpz_t constant, const mpz_t slope)
{
    fraction_set_quotient(root, constant, slope);
    mpz_neg(root->num, root->num);
}

void location_set_root(location *x, const polynomial *curve, const fraction *from,
                       const fraction *to)
{
    x->exact = true;
    if (polynomial_sign(curve, to) == 0) {
        fraction_set(&x->low, to);
    } else if (mpz_sgn(curve->term[2]) == 0) {
        set_linear_root(&x->low, curve->term[0], curve->term[1]);
    } else {
        bool ascending = fraction_compare(from, to) < 0;
        x->exact = false;
        fraction_set(&x->low, ascending ? from : to);
        fraction_set(&x->high, ascending ? to : from);
        polynomial_set(&x->curve, curve);
        x->sign_low = polynomial_sign(curve, &x->low);
    }
}

/* With q the curve and a its leading term, a p = p2 q + r where r is linear, so a p(x) = r(x):
 * the sign of p at a root of q is told by the side of x on which the root of r lies. */
int location_sign(const location *x, const polynomial *p)
{
    if (x->exact)
        return polynomial_sign(p, &x->low);

    const polynomial *q = &x->curve;
    mpz_t rest[2];
    for (int i = 0; i < 2; i++) {
        mpz_init(rest[i]);
        mpz_mul(rest[i], q->term[2], p->term[i]);
        mpz_submul(rest[i], p->term[2], q->term[i]);
    }
    int sign = mpz_sgn(rest[0]);
    int slope = mpz_sgn(rest[1]);
    if (slope != 0) {
        fraction root;
        fraction_init(&root);
        set_linear_root(&root, rest[0], rest[1]);
        sign = slope * location_compare_fraction(x, &root);
        fraction_clear(&root);
    }
    mpz_clears(rest[0], rest[1], (mpz_ptr)NULL);
    return sign * mpz_sgn(q->term[2]);
}

int location_compare_fraction(const location *x, const fraction *y)
{
    if (x->exact)
        return fraction_compare(&x->low, y);
    if (fraction_compare(y, &x->low) <= 0)
        return 1;
    if (fraction_compare(y, &x->high) >= 0)
        return -1;
    return x->sign_low * polynomial_sign(&x->curve, y);
}

int location_compare(const location *x, const location *y)
{
    if (y->exact)
        return location_compare_fraction(x, &y->low);
    if (location_compare_fraction(x, &y->low) <= 0)
        return -1;
    if (location_compare_fraction(x, &y->high) >= 0)
        return 1;
    return -y->sign_low * location_sign(x, &y->curve);
}

int location_bisect(location *x, const fraction *y)
{
    int order = location_compare_fraction(x, y);
    if (x->exact)
        return order;
    if (order > 0 && fraction_compare(y, &x->low) > 0)
        fraction_set(&x->low, y);
    else if (order < 0 && fraction_compare(y, &x->high) < 0)
        fraction_set(&x->high, y);
    return order;
}

/* Halfway from the magnitude with these bits to the next one. */
static void set_midpoint(fraction *middle, uint64_t bits)
{
    long exponent;
    uint64_t mantissa = magnitude(bits, &exponent);
    set_scaled(middle, 2 * mantissa + 1, exponent - 1);
}

/* The number's magnitude rounds to the first bits that need not be raised: those above whose upper
 * midpoint it does not lie, nor on it when they are odd. */
double nearest_double(comparison *compare, void *number)
{
    fraction middle;
    fraction_init(&middle);
    int sign = compare(number, &middle);
    uint64_t first = 0, last = sign == 0 ? 0 : INFINITY_BITS;
    while (first < last) {
        uint64_t bits = first + (last - first) / 2;
        set_midpoint(&middle, bits);
        if (sign < 0)
            mpz_neg(middle.num, middle.num);
        int above = sign * compare(number, &middle);
        if (above > 0 || (above == 0 && bits % 2 == 1))
            first = bits + 1;
        else
            last = bits;
    }
    fraction_clear(&middle);
    return double_from_bits(first | (sign < 0 && first != 0 ? SIGN_BIT : 0));
}

static int bisect_location(void *number, const fraction *y)
{
    return location_bisect(number, y);
}

double location_nearest(location *x)
{
    return nearest_double(bisect_location, x);
}
