/* Integers modulo 2^128 times a power of two (mod128.h), each operation against GMP's integers, and
 * the sign wherever it is told; and the bits of doubles that all that rests on (bits.h). */
#include "../support/suite.h"

#include "../../src/numbers/environment.h"
#include "../../src/numbers/mod128_value.h"

#include <gmp.h>
#include <mpfr.h>
#include <stdio.h>

enum { DRAWS = 20000 };

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

/* Of random bits, what the mathematical library says. */
START_TEST(test_bits)
{
    for (uint64_t i = 0; i < DRAWS; i++) {
        uint64_t bits = suite_bits(300, i);
        double x = draw(i % 3 ? 2 : 3, 301, i), away = copysign(INFINITY, x);
        int e = suite_integer(302, i, 1022);
        bool normal = isnormal(x);
        bool same = is_zero_bits(x) == (x == 0) && is_negative_bits(x) == (signbit(x) != 0) &&
                    is_subnormal_bits(x) == (x != 0 && !normal) && power_of_two(e) == ldexp(1, e) &&
                    exponent_of(x) == (normal ? ilogb(x) : -1023) &&
                    magnitude_bits(x) == bits_of(fabs(x)) && next_away(x) == nextafter(x, away) &&
                    (x == 0 || next_towards_zero(x) == nextafter(x, 0)) &&
                    is_finite_bits(double_of(bits)) == (isfinite(double_of(bits)) != 0);
        if (!same)
            ck_abort_msg("%a", x);
    }
    ck_assert_int_eq(exponent_of(INFINITY), 1024);
    ck_assert(!is_finite_bits(INFINITY) && !is_finite_bits(NAN) && is_finite_bits(DBL_MAX));
    ck_double_same(next_away(DBL_MAX), INFINITY);
    ck_double_same(next_towards_zero(0x1p-1074), 0);
}
END_TEST

#ifdef MOD128_EXISTS

enum { WIDE = 12000 };

/* What is computed, and the number that it stands for, integer 2^exponent. */
typedef struct {
    mod128 low;
    ddb nearly;
    mpz_t integer;
    int exponent;
} operand;

static void set_double(operand *x, double value)
{
    x->low = mod128_of(NULL, value);
    x->nearly = ddb_of(NULL, value);
    mpz_set_d(x->integer, ldexp(frexp(value, &x->exponent), DBL_MANT_DIG));
    x->exponent -= DBL_MANT_DIG;
}

static void align(operand *x, int exponent)
{
    if (x->exponent > exponent) {
        mpz_mul_2exp(x->integer, x->integer, (mp_bitcnt_t)(x->exponent - exponent));
        x->exponent = exponent;
    }
}

/* x = x + sign y; y is a number of its own. */
static void add(operand *x, operand *y, int sign)
{
    align(x, y->exponent);
    align(y, x->exponent);
    (sign < 0 ? mpz_sub : mpz_add)(x->integer, x->integer, y->integer);
    x->low = (sign < 0 ? mod128_sub : mod128_add)(NULL, x->low, y->low);
    x->nearly = (sign < 0 ? ddb_sub : ddb_add)(NULL, x->nearly, y->nearly);
}

static void multiply(operand *x, const operand *y)
{
    mpz_mul(x->integer, x->integer, y->integer);
    x->exponent += y->exponent;
    x->low = mod128_mul(NULL, x->low, y->low);
    x->nearly = ddb_mul(NULL, x->nearly, y->nearly);
}

static void negate(operand *x)
{
    mpz_neg(x->integer, x->integer);
    x->low = mod128_negate(NULL, x->low);
    x->nearly = ddb_negate(NULL, x->nearly);
}

static void copy(operand *x, const operand *y)
{
    x->low = y->low;
    x->nearly = y->nearly;
    mpz_set(x->integer, y->integer);
    x->exponent = y->exponent;
}

/* Is low 2^exponent the integer 2^of_integer, modulo 2^(exponent + 128)? */
static bool is_congruent(mpz_t of_integer, int integer_exponent, uint128 low, int exponent)
{
    mpz_t integer, digits;
    mpz_inits(integer, digits, (mpz_ptr)NULL);
    int shift = integer_exponent - exponent;
    bool divides = true;
    if (shift >= 0) {
        mpz_mul_2exp(integer, of_integer, (mp_bitcnt_t)shift);
    } else {
        divides = mpz_divisible_2exp_p(of_integer, (mp_bitcnt_t)-shift) != 0;
        mpz_tdiv_q_2exp(integer, of_integer, (mp_bitcnt_t)-shift);
    }
    mpz_set_ui(digits, (unsigned long)(low >> 64));
    mpz_mul_2exp(digits, digits, 64);
    mpz_add_ui(digits, digits, (unsigned long)low);
    bool same = mpz_congruent_2exp_p(integer, digits, 128) != 0;
    mpz_clears(integer, digits, (mpz_ptr)NULL);
    return divides && same;
}

static bool is_right(operand *x)
{
    return is_congruent(x->integer, x->exponent, x->low.low, x->low.exponent);
}

typedef struct {
    double x, y;
    mod128 of_x, difference;
} taken;

/* In the caller's environment. */
static void take(taken *t)
{
    t->of_x = mod128_of(NULL, t->x);
    t->difference = mod128_difference_of(NULL, t->x, t->y);
}

static void take_flushed(taken *t)
{
    void (*volatile taking)(taken *) = take;
#ifdef __SSE2_MATH__
    unsigned saved = _mm_getcsr();
    _mm_setcsr(saved | 0x8040);
    taking(t);
    _mm_setcsr(saved);
#else
    taking(t);
#endif
}

static bool same_mod128(mod128 x, mod128 y)
{
    return x.low == y.low && x.exponent == y.exponent;
}

/* An odd integer, or the exponent of zero; flushed or not. */
START_TEST(test_of)
{
    operand x, y;
    mpz_inits(x.integer, y.integer, (mpz_ptr)NULL);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int other = i % 7 == 0 ? (int)(suite_bits(9, i) % 5) : _i;
        taken t = {.x = draw(_i, 10, i), .y = draw(other, 11, i)}, flushed = t;
        take(&t);
        take_flushed(&flushed);
        ck_assert(same_mod128(t.of_x, flushed.of_x));
        ck_assert(same_mod128(t.difference, flushed.difference));
        set_double(&x, t.x);
        set_double(&y, t.y);
        ck_assert(same_mod128(x.low, t.of_x) && is_right(&x));
        ck_assert(t.x == 0 ? t.of_x.low == 0 && t.of_x.exponent == MOD128_EXPONENT_OF_ZERO
                           : t.of_x.low % 2 == 1);
        add(&x, &y, -1);
        ck_assert(same_mod128(x.low, t.difference) && is_right(&x));
    }
    mpz_clears(x.integer, y.integer, (mpz_ptr)NULL);
}
END_TEST

/* In units that are smaller by any number of places. */
START_TEST(test_align)
{
    operand x;
    mpz_init(x.integer);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int places = (int)(i % 160);
        set_double(&x, draw((int)(i % 4), 20, i));
        x.low.low |= (uint128)suite_bits(21, i) << 64;
        mpz_set_ui(x.integer, (unsigned long)(x.low.low >> 64));
        mpz_mul_2exp(x.integer, x.integer, 64);
        mpz_add_ui(x.integer, x.integer, (unsigned long)x.low.low);
        uint128 low = mod128_align(x.low, x.low.exponent - places);
        ck_assert(is_congruent(x.integer, places, low, 0));
        ck_assert(low == mod128_shifted(x.low.low, places));
    }
    mpz_clear(x.integer);
}
END_TEST

/* Is the value of a whole number within its error? Entry: as of mod128_value. */
static bool is_value(const operand *x)
{
    ddb value = mod128_value(x->low);
    mpfr_t truth;
    mpfr_init2(truth, WIDE);
    int inexact = mpfr_set_z_2exp(truth, x->integer, x->exponent, MPFR_RNDN);
    inexact |= mpfr_sub_d(truth, truth, value.hi, MPFR_RNDN);
    inexact |= mpfr_sub_d(truth, truth, value.lo, MPFR_RNDN);
    mpfr_abs(truth, truth, MPFR_RNDN);
    bool within = mpfr_cmp_d(truth, value.error) <= 0;
    mpfr_clear(truth);
    return inexact == 0 && within;
}

/* What was found out, and by which number. */
typedef struct {
    int by_ddb, by_mod128, zeros, uncertain;
} tally;

static void check(operand *x, tally *count)
{
    if (!is_right(x))
        ck_abort_msg("not the integer modulo 2^128, of %a", x->nearly.hi);
    ddb_context nearly = {false};
    int sign, truth = mpz_sgn(x->integer), by_ddb = ddb_sign(&nearly, x->nearly);
    double most = (fabs(x->nearly.hi) + fabs(x->nearly.lo) + x->nearly.error) * (1 + 0x1p-40);
    bool told = mod128_sign(most, x->low, &sign);
    ck_assert(told == mod128_is_whole(most, x->low));
    if ((told && sign != truth) || (!nearly.uncertain && by_ddb != truth))
        ck_abort_msg("sign %d of %a +- %a is %d", sign, x->nearly.hi, x->nearly.error, truth);
    if (told && (x->low.low == 0 || (x->low.exponent >= -1022 && x->low.exponent <= 800)) &&
        !is_value(x))
        ck_abort_msg("not the value of %a", x->nearly.hi);
    count->by_ddb += !nearly.uncertain;
    count->by_mod128 += nearly.uncertain && told;
    count->zeros += nearly.uncertain && told && sign == 0;
    count->uncertain += nearly.uncertain && !told;
}

static void print(const char *name, const tally *count)
{
    printf("%-12s ddb %d, mod128 %d (zeros %d), uncertain %d\n", name, count->by_ddb,
           count->by_mod128, count->zeros, count->uncertain);
}

enum { ENTRIES = 9 };

/* The determinant of three rows of three. */
static void determinant(operand *sum, operand *entry)
{
    static const int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                           {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
    operand term;
    mpz_init(term.integer);
    set_double(sum, 0);
    for (int p = 0; p < 6; p++) {
        copy(&term, &entry[permutations[p][0]]);
        multiply(&term, &entry[3 + permutations[p][1]]);
        multiply(&term, &entry[6 + permutations[p][2]]);
        add(sum, &term, p < 3 ? 1 : -1);
    }
    mpz_clear(term.integer);
}

/* The third row is the sum of the others: exactly, or but for a unit in the last place. The first
 * two have `bits` bits and exponents in -spread..spread. */
static tally determinants(uint64_t stream, int bits, int spread)
{
    tally count = {0, 0, 0, 0};
    operand entry[ENTRIES], sum;
    mpz_init(sum.integer);
    for (int k = 0; k < ENTRIES; k++)
        mpz_init(entry[k].integer);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int64_t m[ENTRIES];
        for (int k = 0; k < ENTRIES; k++)
            m[k] = (int64_t)suite_bits(stream + (uint64_t)k, i) >> (64 - bits);
        for (int k = 0; k < 3; k++)
            m[6 + k] = m[k] + m[3 + k];
        m[6] += (int64_t)(suite_bits(stream + 10, i) % 2);
        for (int k = 0; k < ENTRIES; k++) {
            int scale = suite_integer(stream + 11 + (uint64_t)(k % 3), i, spread);
            set_double(&entry[k], ldexp((double)m[k], scale));
        }
        determinant(&sum, entry);
        check(&sum, &count);
    }
    for (int k = 0; k < ENTRIES; k++)
        mpz_clear(entry[k].integer);
    mpz_clear(sum.integer);
    return count;
}

/* Integers of 20, 40 and 52 bits: all is told, the zeros by the low bits. */
START_TEST(test_determinants)
{
    static const int bits[] = {20, 40, 52};
    for (int spread = 0; spread <= 100; spread += 100) {
        tally count = determinants(100 + 20 * (uint64_t)_i, bits[_i], spread);
        print("determinant", &count);
        ck_assert_int_eq(count.uncertain, 0);
        ck_assert_int_gt(count.by_ddb, DRAWS / 4);
        ck_assert_int_gt(count.zeros, DRAWS / 4);
    }
}
END_TEST

/* Programs of random operations, each result checked. */
START_TEST(test_programs)
{
    enum { REGISTERS = 4, STEPS = 7 };
    tally count = {0, 0, 0, 0};
    operand held[REGISTERS], other;
    mpz_init(other.integer);
    for (int k = 0; k < REGISTERS; k++)
        mpz_init(held[k].integer);
    for (uint64_t i = 0; i < DRAWS / 4; i++) {
        for (int k = 0; k < REGISTERS; k++)
            set_double(&held[k], draw(_i, 200 + (uint64_t)k, i));
        for (uint64_t step = 0; step < STEPS; step++) {
            uint64_t bits = suite_bits(210 + step, i);
            operand *x = &held[bits % REGISTERS];
            copy(&other, &held[(bits >> 8) % REGISTERS]);
            switch ((bits >> 16) % 5) {
            case 0: add(x, &other, 1); break;
            case 1: add(x, &other, -1); break;
            case 2: multiply(x, &other); break;
            case 3: negate(x); break;
            default:
                copy(x, &other);
                multiply(x, &other);
                x->low = mod128_square(NULL, other.low);
            }
            check(x, &count);
        }
    }
    print("program", &count);
    ck_assert_int_gt(count.by_ddb, 0);
    ck_assert_int_gt(count.by_mod128, 0);
    for (int k = 0; k < REGISTERS; k++)
        mpz_clear(held[k].integer);
    mpz_clear(other.integer);
}
END_TEST

/* Of every length in bits, either sign: within the error of the integer times 2^exponent. */
START_TEST(test_value)
{
    operand x;
    mpz_init(x.integer);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int length = 1 + (int)(i % 127);
        uint128 low = (uint128)suite_bits(61, i) << 64 | suite_bits(62, i);
        low >>= 128 - length;
        x.exponent = suite_integer(60, i, 911) - 111;
        x.low = (mod128){low, x.exponent};
        mpz_set_ui(x.integer, (unsigned long)(low >> 64));
        mpz_mul_2exp(x.integer, x.integer, 64);
        mpz_add_ui(x.integer, x.integer, (unsigned long)low);
        if (suite_bits(63, i) % 2 != 0)
            negate(&x);
        ddb value = mod128_value(x.low);
        ck_assert(is_right(&x) && is_value(&x));
        ck_assert(length > 106 || value.error == 0);
        ck_assert(value.error <= 0x1p-105 * fabs(value.hi));
    }
    ddb nothing = mod128_value(mod128_of(NULL, 0));
    ck_assert(ddb_is_zero(nothing) && nothing.lo == 0);
    mpz_clear(x.integer);
}
END_TEST

/* Whole is what is less than 2^127 units, by a factor of two at most too strict. */
START_TEST(test_whole)
{
    for (int exponent = -1000; exponent <= 700; exponent += 50) {
        mod128 x = {1, exponent};
        ck_assert(mod128_is_whole(0, x));
        ck_assert(mod128_is_whole(power_of_two(exponent + 125), x));
        ck_assert(mod128_is_whole(next_towards_zero(power_of_two(exponent + 126)), x));
        ck_assert(!mod128_is_whole(power_of_two(exponent + 127), x));
        ck_assert(!mod128_is_whole(INFINITY, x) && !mod128_is_whole(NAN, x));
    }
    mod128 zero = mod128_of(NULL, 0);
    ck_assert(!mod128_is_whole(INFINITY, zero));
    ck_assert(mod128_is_whole(DBL_MAX, zero));
}
END_TEST

/* Read as a signed number the low bits tell no more than 127 of them: from there on nothing. */
START_TEST(test_edge)
{
    for (int e = 100; e < 140; e++) {
        mod128 large = mod128_of(NULL, power_of_two(e)), one = mod128_of(NULL, 1);
        mod128 x = mod128_sub(NULL, mod128_add(NULL, large, one), large);
        int sign;
        ck_assert(mod128_sign(power_of_two(e), x, &sign) == (e <= 125));
        ck_assert_int_eq(sign, 1);
        ck_assert(mod128_sign(power_of_two(e), mod128_negate(NULL, x), &sign) == (e <= 125));
        ck_assert_int_eq(sign, -1);
        ck_assert(mod128_sign(power_of_two(e), mod128_sub(NULL, x, one), &sign) == (e <= 125));
        ck_assert_int_eq(sign, 0);
    }
}
END_TEST

/* Zeros keep out of every sum, however many are multiplied. */
START_TEST(test_zeros)
{
    mod128 zero = mod128_of(NULL, -0.0), third = mod128_of(NULL, 1 / 3.0), power = zero;
    int sign;
    for (int i = 0; i < 1000; i++)
        power = mod128_mul(NULL, power, zero);
    ck_assert(mod128_sign(DBL_MAX, power, &sign) && sign == 0);
    ck_assert(same_mod128(mod128_add(NULL, power, third), third));
    ck_assert(same_mod128(mod128_sub(NULL, third, power), third));
    ck_assert(same_mod128(mod128_sub(NULL, power, third), mod128_negate(NULL, third)));
    ck_assert(same_mod128(mod128_difference_of(NULL, 1 / 3.0, -0.0), third));
}
END_TEST

static void add_tests(TCase *tests)
{
    tcase_add_loop_test(tests, test_of, 0, 5);
    tcase_add_test(tests, test_align);
    tcase_add_loop_test(tests, test_determinants, 0, 3);
    tcase_add_loop_test(tests, test_programs, 0, 3);
    tcase_add_test(tests, test_value);
    tcase_add_test(tests, test_whole);
    tcase_add_test(tests, test_edge);
    tcase_add_test(tests, test_zeros);
}
#else
static void add_tests(TCase *tests)
{
    (void)tests;
}
#endif

int main(void)
{
    Suite *suite = suite_create("mod128");
    TCase *tests = tcase_create("mod128");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, test_bits);
    add_tests(tests);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
