/* Integers modulo 2^128 counted in a unit (modular.h), each operation against GMP's integers. */
#include "../support/suite.h"

#include "../../src/numbers/environment.h"
#include "../../src/numbers/modular.h"

#include <gmp.h>
#include <mpfr.h>
#include <stdio.h>

#ifdef MODULAR_EXISTS

enum { DRAWS = 20000, NUMBERS = 5, STEPS = 6, UNIT_LEAST = -1074, WIDE = 400 };

/* Of ordinary size, small integers, all exponents with subnormals among them, subnormals, zeros. */
static double draw(int kind, uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i);
    switch (kind) {
    case 0: return suite_double(stream, i, 3);
    case 1: return suite_integer(stream, i, 1000);
    case 2: return is_finite_bits(double_of(bits)) ? double_of(bits) : 0x1p1023;
    case 3: return double_of(bits & (BITS_SIGN | BITS_FRACTION) & ~(UINT64_MAX >> (bits % 64)));
    default: return bits % 2 ? 0.0 : -0.0;
    }
}

/* x / 2^UNIT_LEAST, an integer. */
static void set_integer(mpz_t integer, double x)
{
    int exponent = 0;
    mpz_set_d(integer, ldexp(frexp(x, &exponent), DBL_MANT_DIG));
    exponent -= DBL_MANT_DIG + UNIT_LEAST;
    if (exponent >= 0)
        mpz_mul_2exp(integer, integer, (mp_bitcnt_t)exponent);
    else
        mpz_tdiv_q_2exp(integer, integer, (mp_bitcnt_t)-exponent);
}

static bool is_congruent(mpz_t integer, modular digits)
{
    mpz_t low;
    mpz_init_set_ui(low, (unsigned long)(digits >> 64));
    mpz_mul_2exp(low, low, 64);
    mpz_add_ui(low, low, (unsigned long)digits);
    bool same = mpz_congruent_2exp_p(integer, low, 128) != 0;
    mpz_clear(low);
    return same;
}

typedef struct {
    double numbers[NUMBERS];
    modular_context unit;
    modular digits[NUMBERS], difference;
} fitted;

/* In the caller's environment. */
static void fit_all(fitted *f)
{
    f->unit.exponent = MODULAR_UNIT_OF_ZEROS;
    for (int k = 0; k < NUMBERS; k++)
        modular_fit(&f->unit, f->numbers[k]);
    for (int k = 0; k < NUMBERS; k++)
        f->digits[k] = modular_of(&f->unit, f->numbers[k]);
    f->difference = modular_difference_of(&f->unit, f->numbers[0], f->numbers[1]);
}

static void fit_flushed(fitted *f)
{
    void (*volatile fit)(fitted *) = fit_all;
#ifdef __SSE2_MATH__
    unsigned saved = _mm_getcsr();
    _mm_setcsr(saved | 0x8040);
    fit(f);
    _mm_setcsr(saved);
#else
    fit(f);
#endif
}

/* Every number is the unit times an integer of those digits, and one of them an odd multiple. */
static void check_unit(const fitted *f)
{
    mpz_t integer;
    bool is_odd = false, is_zero = true;
    mp_bitcnt_t unit = (mp_bitcnt_t)(f->unit.exponent - UNIT_LEAST);
    mpz_init(integer);
    for (int k = 0; k < NUMBERS; k++) {
        set_integer(integer, f->numbers[k]);
        bool holds = mpz_divisible_2exp_p(integer, unit) != 0;
        is_zero = is_zero && mpz_sgn(integer) == 0;
        mpz_tdiv_q_2exp(integer, integer, unit);
        is_odd = is_odd || mpz_odd_p(integer);
        if (!holds || !is_congruent(integer, f->digits[k]))
            ck_abort_msg("the digits of %a in units of 2^%d", f->numbers[k], f->unit.exponent);
    }
    ck_assert(is_odd || is_zero);
    mpz_clear(integer);
}

START_TEST(test_units)
{
    mpz_t x, y;
    mpz_inits(x, y, (mpz_ptr)NULL);
    for (uint64_t i = 0; i < DRAWS; i++) {
        fitted f, flushed;
        for (int k = 0; k < NUMBERS; k++)
            f.numbers[k] = draw(i % 7 == 0 ? (int)(suite_bits(9, i + (uint64_t)k) % 5) : _i,
                                10 + (uint64_t)k, i);
        flushed = f;
        fit_all(&f);
        fit_flushed(&flushed);
        check_unit(&f);
        for (int k = 0; k < NUMBERS; k++)
            ck_assert(f.digits[k] == flushed.digits[k]);
        ck_assert(f.difference == flushed.difference && f.unit.exponent == flushed.unit.exponent);
        set_integer(x, f.numbers[0]);
        set_integer(y, f.numbers[1]);
        mpz_sub(x, x, y);
        mpz_tdiv_q_2exp(x, x, (mp_bitcnt_t)(f.unit.exponent - UNIT_LEAST));
        ck_assert(is_congruent(x, f.difference));
    }
    mpz_clears(x, y, (mpz_ptr)NULL);
}
END_TEST

/* What an operation makes of both: modulo 2^128, and whole. */
static modular operate(int what, modular x, modular y, mpz_t of_x, mpz_t of_y)
{
    switch (what) {
    case 0: mpz_add(of_x, of_x, of_y); return modular_add(NULL, x, y);
    case 1: mpz_sub(of_x, of_x, of_y); return modular_sub(NULL, x, y);
    case 2: mpz_mul(of_x, of_x, of_y); return modular_mul(NULL, x, y);
    case 3: mpz_mul(of_x, of_x, of_x); return modular_square(NULL, x);
    case 4: mpz_neg(of_x, of_x); return modular_negate(NULL, x);
    default: {
        int places = (int)(mpz_get_ui(of_y) % 160);
        mpz_mul_2exp(of_x, of_x, (mp_bitcnt_t)places);
        return modular_shifted(x, places);
    }
    }
}

START_TEST(test_operations)
{
    modular_context unit = {-1074};
    mpz_t x, y;
    mpz_inits(x, y, (mpz_ptr)NULL);
    for (uint64_t i = 0; i < DRAWS; i++) {
        double first = suite_double(20, i, 3) * 0x1p-1020;
        modular low = modular_of(&unit, first);
        set_integer(x, first);
        for (uint64_t step = 0; step < STEPS; step++) {
            double other =
                (suite_bits(21 + step, i) % 2 ? suite_double(31 + step, i, 3) * 0x1p-1020
                                              : suite_integer(41 + step, i, 9) * 0x1p-1074);
            set_integer(y, other);
            low = operate((int)(suite_bits(51 + step, i) % 6), low, modular_of(&unit, other), x, y);
            ck_assert(is_congruent(x, low));
        }
    }
    mpz_clears(x, y, (mpz_ptr)NULL);
}
END_TEST

/* Of every length in bits, either sign: within the error of the integer times 2^exponent. */
START_TEST(test_value)
{
    mpfr_t truth;
    mpfr_init2(truth, WIDE);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int exponent = suite_integer(60, i, 911) - 111, length = 1 + (int)(i % 127);
        modular x = (modular)suite_bits(61, i) << 64 | suite_bits(62, i);
        x >>= 128 - length;
        mpfr_set_uj(truth, (uint64_t)(x >> 64), MPFR_RNDN);
        mpfr_mul_2si(truth, truth, 64, MPFR_RNDN);
        mpfr_t low;
        mpfr_init2(low, WIDE);
        mpfr_set_uj(low, (uint64_t)x, MPFR_RNDN);
        mpfr_add(truth, truth, low, MPFR_RNDN);
        mpfr_clear(low);
        mpfr_mul_2si(truth, truth, exponent, MPFR_RNDN);
        bool negative = suite_bits(63, i) % 2 != 0;
        if (negative)
            mpfr_neg(truth, truth, MPFR_RNDN);
        near value = modular_value(negative ? -x : x, exponent);
        mpfr_sub_d(truth, truth, value.hi, MPFR_RNDN);
        mpfr_sub_d(truth, truth, value.lo, MPFR_RNDN);
        mpfr_abs(truth, truth, MPFR_RNDN);
        ck_assert(mpfr_cmp_d(truth, value.error) <= 0);
        ck_assert(length > 106 || value.error == 0);
        ck_assert(value.error <= 0x1p-105 * fabs(value.hi));
    }
    mpfr_clear(truth);
}
END_TEST

/* Whole is what is less than 2^127 units, by a factor of two at most too strict. */
START_TEST(test_whole)
{
    for (int exponent = -1000; exponent <= 700; exponent += 50) {
        ck_assert(modular_is_whole(0, exponent));
        ck_assert(modular_is_whole(power_of_two(exponent + 125), exponent));
        ck_assert(modular_is_whole(next_towards_zero(power_of_two(exponent + 126)), exponent));
        ck_assert(!modular_is_whole(power_of_two(exponent + 127), exponent));
        ck_assert(!modular_is_whole(INFINITY, exponent) && !modular_is_whole(NAN, exponent));
    }
    ck_assert(!modular_is_whole(INFINITY, MODULAR_UNIT_OF_ZEROS));
    ck_assert(modular_is_whole(DBL_MAX, MODULAR_UNIT_OF_ZEROS));
}
END_TEST

static void add_tests(TCase *tests)
{
    tcase_add_loop_test(tests, test_units, 0, 5);
    tcase_add_test(tests, test_operations);
    tcase_add_test(tests, test_value);
    tcase_add_test(tests, test_whole);
}
#else
static void add_tests(TCase *tests)
{
    (void)tests;
}
#endif

int main(void)
{
    Suite *suite = suite_create("modular");
    TCase *tests = tcase_create("modular");
    tcase_set_timeout(tests, 60);
    add_tests(tests);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
