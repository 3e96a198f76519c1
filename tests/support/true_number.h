/* SPDX-License-Identifier: MIT */
/* Numbers of MPFR, of so many bits, and GMP's rationals: up to four of them declared, begun, and
 * cleared at the end of their block. */
#pragma once

#include <stdlib.h>
#include <stdio.h> /* before theirs, which have gmp_fprintf only then */

#include <gmp.h>
#include <mpfr.h>

static inline void true_number_clear(mpfr_t *x)
{
    mpfr_clear(*x);
}

static inline void true_rational_clear(mpq_t *x)
{
    mpq_clear(*x);
}

/* x 2^exponent */
static inline void shift(mpq_t x, int exponent)
{
    (exponent < 0 ? mpq_div_2exp : mpq_mul_2exp)(x, x, (mp_bitcnt_t)abs(exponent));
}

#define TRUE_NUMBER(bits, x)                                                                       \
    __attribute__((cleanup(true_number_clear))) mpfr_t x;                                          \
    mpfr_init2(x, bits)
#define TRUE_RATIONAL(unused, x)                                                                   \
    __attribute__((cleanup(true_rational_clear))) mpq_t x;                                         \
    mpq_init(x)

#define TRUE_1(one, bits, w) one(bits, w)
#define TRUE_2(one, bits, w, x)                                                                    \
    TRUE_1(one, bits, w);                                                                          \
    one(bits, x)
#define TRUE_3(one, bits, w, x, y)                                                                 \
    TRUE_2(one, bits, w, x);                                                                       \
    one(bits, y)
#define TRUE_4(one, bits, w, x, y, z)                                                              \
    TRUE_3(one, bits, w, x, y);                                                                    \
    one(bits, z)
#define TRUE_OF(w, x, y, z, all, ...) all
#define TRUE_EACH(one, bits, ...)                                                                  \
    TRUE_OF(__VA_ARGS__, TRUE_4, TRUE_3, TRUE_2, TRUE_1, 0)(one, bits, __VA_ARGS__)
#define TRUE_NUMBERS(bits, ...) TRUE_EACH(TRUE_NUMBER, bits, __VA_ARGS__)
#define TRUE_RATIONALS(...) TRUE_EACH(TRUE_RATIONAL, 0, __VA_ARGS__)
