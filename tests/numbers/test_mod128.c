/* SPDX-License-Identifier: MIT */
/* Integers modulo 2^128 times a power of two (mod128.h), each operation against GMP's integers, and
 * the sign wherever it is told, in both forms of uint128; and the bits of doubles that all that
 * rests on (bits.h). */
#include "../support/suite.h"
#include "../support/surroundings.h"
#include "../support/true_number.h"

#include "../../src/numbers/mod128_value.h"
#include "../../src/numbers/places.h"

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
TEST(test_bits)
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

/* What is computed, and the number that it stands for. */
typedef struct {
    mod128 low;
    ddb nearly;
    mpq_t truth;
} operand;

static void operand_clear(operand *x)
{
    mpq_clear(x->truth);
}

/* Declares and begins up to four. */
#define OPERAND(unused, x)                                                                         \
    FREED_BY(operand_clear) operand x;                                                             \
    mpq_init(x.truth)
#define OPERANDS(...) TRUE_EACH(OPERAND, 0, __VA_ARGS__)

static void set_double(operand *x, double value)
{
    x->low = mod128_of(NULL, value);
    x->nearly = ddb_of(NULL, value);
    mpq_set_d(x->truth, value);
}

/* x = x + sign y */
static void add(operand *x, const operand *y, int sign)
{
    (sign < 0 ? mpq_sub : mpq_add)(x->truth, x->truth, y->truth);
    x->low = (sign < 0 ? mod128_sub : mod128_add)(NULL, x->low, y->low);
    x->nearly = (sign < 0 ? ddb_sub : ddb_add)(NULL, x->nearly, y->nearly);
}

static void multiply(operand *x, const operand *y)
{
    mpq_mul(x->truth, x->truth, y->truth);
    x->low = mod128_mul(NULL, x->low, y->low);
    x->nearly = ddb_mul(NULL, x->nearly, y->nearly);
}

static void negate(operand *x)
{
    mpq_neg(x->truth, x->truth);
    x->low = mod128_negate(NULL, x->low);
    x->nearly = ddb_negate(NULL, x->nearly);
}

static void copy(operand *x, const operand *y)
{
    x->low = y->low;
    x->nearly = y->nearly;
    mpq_set(x->truth, y->truth);
}

static void set_low(mpq_t x, uint128 low, int exponent)
{
    mpq_set_ui(x, UINT128_HIGH(low), 1);
    shift(x, 64);
    mpz_add_ui(mpq_numref(x), mpq_numref(x), UINT128_LOW(low));
    shift(x, exponent);
}

/* Is low 2^exponent the number, modulo 2^(exponent + 128)? */
static bool is_congruent(const mpq_t truth, uint128 low, int exponent)
{
    TRUE_RATIONALS(off);
    set_low(off, low, exponent);
    mpq_sub(off, truth, off);
    shift(off, -exponent - 128);
    return mpz_cmp_ui(mpq_denref(off), 1) == 0;
}

static bool is_right(const operand *x)
{
    return is_congruent(x->truth, x->low.low, x->low.exponent);
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
    surroundings_set(SURROUNDINGS_MODES);
    taking(t);
    surroundings_set(0);
}

static bool same_mod128(mod128 x, mod128 y)
{
    return UINT128_HIGH(x.low) == UINT128_HIGH(y.low) && UINT128_LOW(x.low) == UINT128_LOW(y.low) &&
           x.exponent == y.exponent;
}

/* An odd integer, or the exponent of zero; flushed or not. */
LOOP_TEST(test_of, 5)
{
    OPERANDS(x, y);
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
        ck_assert(t.x == 0 ? mod128_is_zero(t.of_x) && t.of_x.exponent == MOD128_EXPONENT_OF_ZERO
                           : UINT128_LOW(t.of_x.low) % 2 == 1);
        add(&x, &y, -1);
        ck_assert(same_mod128(x.low, t.difference) && is_right(&x));
    }
}

/* In units that are smaller by any number of places. */
TEST(test_align)
{
    OPERANDS(x);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int places = (int)(i % 160);
        set_double(&x, draw((int)(i % 4), 20, i));
        uint64_t high = UINT128_HIGH(x.low.low) | suite_bits(21, i);
        x.low.low = UINT128(high, UINT128_LOW(x.low.low));
        set_low(x.truth, x.low.low, places);
        mod128 aligned = {mod128_align(x.low, x.low.exponent - places), 0};
        ck_assert(is_congruent(x.truth, aligned.low, 0));
        ck_assert(same_mod128(aligned, (mod128){mod128_shifted(x.low.low, places), 0}));
    }
}

/* Is the number within the error of a double-double? */
static bool is_within(const mpq_t truth, ddb value)
{
    const double parts[] = {value.hi, value.lo};
    TRUE_RATIONALS(off, part);
    mpq_set(off, truth);
    for (int i = 0; i < 2; i++) {
        mpq_set_d(part, parts[i]);
        mpq_sub(off, off, part);
    }
    mpq_abs(off, off);
    mpq_set_d(part, value.error);
    return mpq_cmp(off, part) <= 0;
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
    int sign, truth = mpq_sgn(x->truth), by_ddb = ddb_sign(&nearly, x->nearly);
    double most = (fabs(x->nearly.hi) + fabs(x->nearly.lo) + x->nearly.error) * (1 + 0x1p-40);
    bool told = mod128_sign(most, x->low, &sign);
    ck_assert(told == mod128_is_whole(most, x->low));
    if ((told && sign != truth) || (!nearly.uncertain && by_ddb != truth))
        ck_abort_msg("sign %d of %a +- %a is %d", sign, x->nearly.hi, x->nearly.error, truth);
    if (isfinite(x->nearly.hi) && isfinite(x->nearly.error) && !is_within(x->truth, x->nearly))
        ck_abort_msg("%a + %a +- %a is wrong", x->nearly.hi, x->nearly.lo, x->nearly.error);
    if (told && (mod128_is_zero(x->low) || (x->low.exponent >= -1022 && x->low.exponent <= 800)) &&
        !is_within(x->truth, mod128_value(x->low)))
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
    OPERANDS(term);
    set_double(sum, 0);
    for (int p = 0; p < 6; p++) {
        copy(&term, &entry[permutations[p][0]]);
        multiply(&term, &entry[3 + permutations[p][1]]);
        multiply(&term, &entry[6 + permutations[p][2]]);
        add(sum, &term, p < 3 ? 1 : -1);
    }
}

/* The third row is the sum of the others: exactly, or but for a unit in the last place. The first
 * two have `bits` bits and exponents in -spread..spread. */
static tally determinants(uint64_t stream, int bits, int spread)
{
    tally count = {0, 0, 0, 0};
    operand entry[ENTRIES];
    OPERANDS(sum);
    for (int k = 0; k < ENTRIES; k++)
        mpq_init(entry[k].truth);
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
        mpq_clear(entry[k].truth);
    return count;
}

/* Integers of 20, 40 and 52 bits: all is told, the zeros by the low bits. */
LOOP_TEST(test_determinants, 3)
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

/* Programs of random operations, each result checked. */
LOOP_TEST(test_programs, 3)
{
    enum { REGISTERS = 4, STEPS = 7 };
    tally count = {0, 0, 0, 0};
    operand held[REGISTERS];
    OPERANDS(other);
    for (int k = 0; k < REGISTERS; k++)
        mpq_init(held[k].truth);
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
        mpq_clear(held[k].truth);
}

/* The nearest double, where what decides lies halfway, just off, or anywhere. */
TEST(test_rounded)
{
    OPERANDS(x);
    TRUE_NUMBERS(53, nearest);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int length = 54 + (int)(i % 74), last = length - 54; /* the first bit that is dropped */
        uint64_t led = suite_bits(64, i) >> 11 << 1 | UINT64_C(1) << 53 | (i / 74 % 4 != 0);
        uint128 whole = uint128_shifted(UINT128(0, led), last);
        if (last > 0 && i / 74 % 3 != 0)
            whole = uint128_add(whole, UINT128(0, i / 74 % 3 == 1 ? 1 : suite_bits(65, i) >> 63));
        set_low(x.truth, whole, 0);
        mpfr_set_q(nearest, x.truth, MPFR_RNDN);
        ck_double_same(uint128_rounded(whole), mpfr_get_d(nearest, MPFR_RNDN));
    }
}

/* Of every length in bits, either sign: within the error of the integer times 2^exponent. */
TEST(test_value)
{
    OPERANDS(x);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int length = 1 + (int)(i % 127);
        uint64_t first = suite_bits(61, i), second = suite_bits(62, i);
        uint128 low = length > 64 ? UINT128(first >> (128 - length), second)
                                  : UINT128(0, second >> (64 - length));
        x.low = (mod128){low, suite_integer(60, i, 911) - 111};
        set_low(x.truth, low, x.low.exponent);
        if (suite_bits(63, i) % 2 != 0)
            negate(&x);
        ddb value = mod128_value(x.low);
        ck_assert(is_right(&x) && is_within(x.truth, value));
        ck_assert(length > 106 || value.error == 0);
        ck_assert(value.error <= 0x1p-105 * fabs(value.hi));
    }
    ddb nothing = mod128_value(mod128_of(NULL, 0));
    ck_assert(ddb_is_zero(nothing) && nothing.lo == 0);
}

/* Whole is what is less than 2^127 units, by a factor of two at most too strict. */
TEST(test_whole)
{
    for (int exponent = -1000; exponent <= 700; exponent += 50) {
        mod128 x = {UINT128(0, 1), exponent};
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

/* Read as a signed number the low bits tell no more than 127 of them: from there on nothing. */
TEST(test_edge)
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

/* Zeros keep out of every sum, however many are multiplied. */
TEST(test_zeros)
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

SUITE("mod128")
