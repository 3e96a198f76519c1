/* SPDX-License-Identifier: MIT */
/* The numbers of the bisection oracle: integers (GMP) and nothing else. A double is read and
 * written by its bits, so that no floating-point operation takes place and neither the rounding
 * mode nor flush-to-zero can matter. */
#ifndef REFERENCE_BISECTION_NUMBER_H
#define REFERENCE_BISECTION_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

#include <gmp.h>

#define INFINITY_BITS UINT64_C(0x7ff0000000000000)
#define SIGN_BIT (UINT64_C(1) << 63)

uint64_t double_bits(double value);
double double_from_bits(uint64_t bits);
bool double_is_finite(double value);
bool double_is_zero(double value); /* either zero */

/* |value| = mantissa * 2^exponent, the mantissa odd; 0 and 0 for a zero. Entry: finite. */
uint64_t double_split(double value, long *exponent);

/* out = value / 2^exponent. Entry: finite, and the quotient is an integer. */
void integer_from(mpz_t out, double value, long exponent);

/* num/den with den > 0, not necessarily in lowest terms. */
typedef struct {
    mpz_t num, den;
} fraction;

void fraction_init(fraction *x);
void fraction_clear(fraction *x);
void fraction_set(fraction *x, const fraction *y);
void fraction_set_integer(fraction *x, long value);
void fraction_set_double(fraction *x, double value);
void fraction_set_quotient(fraction *x, const mpz_t num, const mpz_t den); /* den != 0 */
int fraction_compare(const fraction *x, const fraction *y);                /* sign of x - y */

/* term[0] + term[1] t + term[2] t^2 with integer terms. */
typedef struct {
    mpz_t term[3];
} polynomial;

void polynomial_init(polynomial *p);
void polynomial_clear(polynomial *p);
int polynomial_sign(const polynomial *p, const fraction *t);

/* A real number known by where a polynomial changes sign. It is `low` itself when `exact`;
 * otherwise the one root of `curve` strictly between `low` and `high`, and `curve` is of degree
 * two, not 0 at either of them and of opposite signs there. */
typedef struct {
    bool exact;
    fraction low, high;
    polynomial curve;
    int sign_low; /* of curve at low */
} location;

void location_init(location *x);
void location_clear(location *x);
void location_set(location *x, const location *y);
void location_set_fraction(location *x, const fraction *value);

/* The one root of `curve` in the closed interval whose ends are given in either order, where it
 * is 0 at `to` or changes sign between them, `from` not being a root. */
void location_set_root(location *x, const polynomial *curve, const fraction *from,
                       const fraction *to);

/* The sign of p at x. */
int location_sign(const location *x, const polynomial *p);

/* The sign of x - y. */
int location_compare_fraction(const location *x, const fraction *y);
int location_compare(const location *x, const location *y);

/* The same sign, and the interval of x shrinks to the side of y on which x lies. */
int location_bisect(location *x, const fraction *y);

/* A number that can only be compared: the sign of number - y. */
typedef int comparison(void *number, const fraction *y);

/* The double nearest to the number, ties to even, overflow to an infinity, every zero +0: found by
 * bisection over the doubles, in the order of their bits. */
double nearest_double(comparison *compare, void *number);
double location_nearest(location *x);

#endif
