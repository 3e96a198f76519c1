/* The bits of doubles; and numbers known nearly and modulo 2^128: the integer is checked after each
 * step, and the sign wherever it is told. */
#include "../support/suite.h"

#include "../../src/numbers/residue.h"

#include <mpfr.h>
#include <stdio.h>

enum { DRAWS = 20000, WIDE = 12000 };

/* A residue and the number that it stands for, integer 2^exponent. */
typedef struct {
    residue rounded;
    mpz_t integer;
    int exponent;
} operand;

static void set_double(operand *x, double value)
{
    x->rounded = residue_of(NULL, value);
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
    x->rounded = (sign < 0 ? residue_sub : residue_add)(NULL, x->rounded, y->rounded);
}

static void multiply(operand *x, const operand *y)
{
    mpz_mul(x->integer, x->integer, y->integer);
    x->exponent += y->exponent;
    x->rounded = residue_mul(NULL, x->rounded, y->rounded);
}

static void copy(operand *x, const operand *y)
{
    x->rounded = y->rounded;
    mpz_set(x->integer, y->integer);
    x->exponent = y->exponent;
}

#ifdef __SIZEOF_INT128__
static bool is_residue(const operand *x)
{
    mpz_t integer, low;
    mpz_inits(integer, low, (mpz_ptr)NULL);
    int shift = x->exponent - x->rounded.exponent;
    bool divides = true;
    if (shift >= 0) {
        mpz_mul_2exp(integer, x->integer, (mp_bitcnt_t)shift);
    } else {
        divides = mpz_divisible_2exp_p(x->integer, (mp_bitcnt_t)-shift) != 0;
        mpz_tdiv_q_2exp(integer, x->integer, (mp_bitcnt_t)-shift);
    }
    mpz_set_ui(low, (unsigned long)(x->rounded.low >> 64));
    mpz_mul_2exp(low, low, 64);
    mpz_add_ui(low, low, (unsigned long)x->rounded.low);
    bool same = mpz_congruent_2exp_p(integer, low, 128) != 0;
    mpz_clears(integer, low, (mpz_ptr)NULL);
    return divides && same;
}
#else
static bool is_residue(const operand *x)
{
    return x != NULL;
}
#endif

/* Is the value within its near number's bound, and within the residue's? Where it is whole, that is
 * at most half an ulp of the low part. */
static bool is_value(const operand *x)
{
    near value = residue_value(x->rounded);
    if (mpz_sizeinbase(x->integer, 2) > WIDE / 2 || !is_finite_bits(x->rounded.near.error))
        return true;
    mpfr_t truth;
    mpfr_init2(truth, WIDE);
    int inexact = mpfr_set_z_2exp(truth, x->integer, x->exponent, MPFR_RNDN);
    inexact |= mpfr_sub_d(truth, truth, value.hi, MPFR_RNDN);
    inexact |= mpfr_sub_d(truth, truth, value.lo, MPFR_RNDN);
    mpfr_abs(truth, truth, MPFR_RNDN);
    bool within = mpfr_cmp_d(truth, value.error) <= 0;
    mpfr_clear(truth);
    return inexact == 0 && within && value.error <= x->rounded.near.error;
}

/* What was found out, and by which half. */
typedef struct {
    int by_near, by_residue, zeros, uncertain;
} tally;

static void check(const operand *x, tally *count)
{
    if (!is_residue(x))
        ck_abort_msg("not the integer modulo 2^128, of %a", x->rounded.near.hi);
    if (!is_value(x))
        ck_abort_msg("not the value of %a", x->rounded.near.hi);
    residue_context context = {false};
    near_context near_alone = {false};
    int sign = residue_sign(&context, x->rounded), truth = mpz_sgn(x->integer);
    (void)near_sign(&near_alone, x->rounded.near);
    if (context.uncertain) {
        count->uncertain++;
        if (sign != 0 || !near_alone.uncertain)
            ck_abort_msg("uncertain, sign %d, of %a", sign, x->rounded.near.hi);
        return;
    }
    if (sign != truth)
        ck_abort_msg("sign %d of %a +- %a is %d", sign, x->rounded.near.hi, x->rounded.near.error,
                     truth);
    if (near_alone.uncertain) {
        count->by_residue++;
        count->zeros += sign == 0;
    } else {
        count->by_near++;
    }
}

static void print(const char *name, const tally *count)
{
    printf("%-20s near %d, residue %d (zeros %d), uncertain %d\n", name, count->by_near,
           count->by_residue, count->zeros, count->uncertain);
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

/* Integers of 20, 40 and 52 bits: all is told, the zeros by the residue. */
START_TEST(test_determinants)
{
    static const int bits[] = {20, 40, 52};
    for (int spread = 0; spread <= 100; spread += 100) {
        tally count = determinants(100 + 20 * (uint64_t)_i, bits[_i], spread);
        print("determinant", &count);
        ck_assert_int_eq(count.uncertain, 0);
        ck_assert_int_gt(count.by_near, DRAWS / 4);
        ck_assert_int_gt(count.zeros, DRAWS / 4);
    }
}
END_TEST

/* Registers of full doubles, of small integers, and of the whole range with subnormals. */
static double draw(int kind, uint64_t stream, uint64_t i)
{
    switch (kind) {
    case 0: return suite_double(stream, i, 3);
    case 1: return suite_integer(stream, i, 3);
    default: {
        uint64_t bits = suite_bits(stream, i);
        double x = double_of(bits % 3 ? bits : bits & (BITS_SIGN | BITS_FRACTION));
        return is_finite_bits(x) ? x : 0;
    }
    }
}

/* Programs of random sums, differences, products and squares, each result checked. */
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
            switch ((bits >> 16) % 4) {
            case 0: add(x, &other, 1); break;
            case 1: add(x, &other, -1); break;
            case 2: multiply(x, &other); break;
            default:
                copy(x, &other);
                multiply(x, &other);
                x->rounded = residue_square(NULL, other.rounded);
            }
            check(x, &count);
        }
    }
    print("program", &count);
    ck_assert_int_gt(count.by_near, 0);
    ck_assert_int_gt(count.by_residue, 0);
    for (int k = 0; k < REGISTERS; k++)
        mpz_clear(held[k].integer);
    mpz_clear(other.integer);
}
END_TEST

/* Read as a signed word the residue tells no more than 127 bits: from there on nothing. */
START_TEST(test_edge)
{
    residue_context context = {false};
    for (int e = 100; e < 140; e++) {
        residue large = residue_of(&context, power_of_two(e)), one = residue_of(&context, 1);
        residue x = residue_sub(&context, residue_add(&context, large, one), large);
        x.near.error = power_of_two(e);
        context.uncertain = false;
        ck_assert_int_eq(residue_sign(&context, x), e <= 125);
        ck_assert_int_eq(context.uncertain, e > 125);
        ck_assert_int_eq(residue_sign(&context, residue_negate(&context, x)), -(e <= 125));
        context.uncertain = false;
        x = residue_sub(&context, x, one);
        x.near.error = power_of_two(e);
        ck_assert_int_eq(residue_sign(&context, x), 0);
        ck_assert_int_eq(context.uncertain, e > 125);
    }
}
END_TEST

/* Zeros keep out of every sum, however many are multiplied; overflow tells nothing. */
START_TEST(test_zeros)
{
    residue_context context = {false};
    residue zero = residue_of(&context, -0.0), third = residue_of(&context, 1 / 3.0), power = zero;
    for (int i = 0; i < 1000; i++)
        power = residue_mul(&context, power, zero);
    ck_assert_int_eq(residue_sign(&context, power), 0);
    ck_assert_int_eq(residue_sign(&context, residue_add(&context, power, third)), 1);
    ck_assert_int_eq(residue_sign(&context, residue_sub(&context, power, third)), -1);
    residue square = residue_square(&context, third);
    ck_assert_int_eq(residue_sign(&context, residue_sub(&context, square, square)), 0);
    ck_assert(!context.uncertain);
    residue huge = residue_of(&context, 0x1p+1000);
    residue beyond = residue_mul(&context, huge, huge);
    ck_assert_int_eq(residue_sign(&context, residue_sub(&context, beyond, beyond)), 0);
    ck_assert(context.uncertain);
}
END_TEST

/* Of random bits, what the mathematical library says. */
START_TEST(test_bits)
{
    for (uint64_t i = 0; i < DRAWS; i++) {
        uint64_t bits = suite_bits(300, i);
        double x = draw(2, 301, i), away = copysign(INFINITY, x);
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

int main(void)
{
    Suite *suite = suite_create("residue");
    TCase *tests = tcase_create("residue");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, test_determinants, 0, 3);
    tcase_add_loop_test(tests, test_programs, 0, 3);
    tcase_add_test(tests, test_edge);
    tcase_add_test(tests, test_zeros);
    tcase_add_test(tests, test_bits);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
