/* SPDX-License-Identifier: MIT */
/* Each operation of wide.h, on numbers at either end of what they may be off by, or within: is the
 * true result within the bound? And what is rounded by it is rounded as by an exact division. All
 * that is true is an MPFR number wide enough to be exact, but for quotients and roots. */
#include "../support/suite.h"
#include "../support/true_number.h"

#include "../../src/numbers/bits.h"
#include "../../src/stages/last/wide.h"

enum { DRAWS = 40000, WIDE = 1200 };

typedef enum { ADD, MUL, DIV, ROOT, OPERATIONS } operation;
static const char *const names[OPERATIONS] = {"add", "mul", "div", "sqrt"};

static const uint64_t least = UINT64_C(1) << 63, unknown = UINT64_C(1) << 31;

/* The digits' ends, and any. */
static uint64_t draw_digits(uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i), few = bits & 3;
    return bits >> 62 == 0 ? least + few : bits >> 62 == 1 ? ~few : bits | least;
}

static wide draw(uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i);
    int off_bits = (int)(bits >> 8) % 31;
    wide x = {draw_digits(stream + 1, i), suite_bits(stream + 2, i) & ((1U << off_bits) - 1),
              suite_integer(stream + 3, i, bits % 4 ? 3 : 100), bits % 2 ? 1 : -1};
    if (bits % 64 == 0)
        x = (wide){0, bits % 128 ? x.off : 0, x.exponent, 0};
    return x;
}

static void set_digits(mpfr_t x, uint64_t digits)
{
    mpfr_set_ui_2exp(x, (unsigned long)(digits >> 32), 32, MPFR_RNDN);
    mpfr_add_ui(x, x, (unsigned long)(uint32_t)digits, MPFR_RNDN);
}

/* At an end of what x may be, or within. */
static void draw_truth(mpfr_t truth, wide x, uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i);
    long off = bits % 3 == 0 ? (long)x.off : bits % 3 == 1 ? -(long)x.off : 0;
    if (bits % 16 == 15 && x.off > 0)
        off = (long)((bits >> 8) % x.off);
    set_digits(truth, x.digits);
    mpfr_mul_si(truth, truth, x.sign, MPFR_RNDN);
    mpfr_add_si(truth, truth, off, MPFR_RNDN);
    mpfr_mul_2si(truth, truth, x.exponent, MPFR_RNDN);
}

static wide operate(operation what, wide x, wide y)
{
    switch (what) {
    case ADD: return wide_add(x, y);
    case MUL: return wide_mul(x, y);
    case DIV: return wide_div(x, y);
    default: return wide_sqrt(x);
    }
}

static void true_operation(operation what, mpfr_t result, mpfr_t x, mpfr_t y)
{
    switch (what) {
    case ADD: ck_assert_int_eq(mpfr_add(result, x, y, MPFR_RNDN), 0); break;
    case MUL: ck_assert_int_eq(mpfr_mul(result, x, y, MPFR_RNDN), 0); break;
    case DIV: mpfr_div(result, x, y, MPFR_RNDN); break;
    default: mpfr_sqrt(result, x, MPFR_RNDN); break;
    }
}

/* How far the result is from the true one, over what it may be; 0 where nothing is known of it. */
static double share_of_bound(wide z, mpfr_t truth)
{
    TRUE_NUMBERS(WIDE, distance, bound);
    if (z.off >= unknown)
        return 0;
    ck_assert((z.digits == 0) == (z.sign == 0) && (z.digits == 0 || z.digits >= least));
    set_digits(distance, z.digits);
    mpfr_mul_si(distance, distance, z.sign, MPFR_RNDN);
    mpfr_mul_2si(distance, distance, z.exponent, MPFR_RNDN);
    mpfr_sub(distance, distance, truth, MPFR_RNDN);
    if (mpfr_zero_p(distance))
        return 0;
    set_digits(bound, z.off);
    mpfr_mul_2si(bound, bound, z.exponent, MPFR_RNDN);
    mpfr_div(bound, distance, bound, MPFR_RNDA);
    return fabs(mpfr_get_d(bound, MPFR_RNDA));
}

LOOP_TEST(test_bounds, OPERATIONS)
{
    operation what = (operation)_i;
    uint64_t stream = 100 * (uint64_t)_i;
    int known = 0;
    double worst = 0;
    TRUE_NUMBERS(WIDE, x_truth, y_truth, result);
    for (uint64_t i = 0; i < DRAWS; i++) {
        wide x = draw(stream, i), y = draw(stream + 10, i);
        if (what == ADD && suite_bits(stream + 20, i) % 2 == 0) { /* close ones cancel */
            y = (wide){x.digits ^ (suite_bits(stream + 21, i) & 7), y.off, x.exponent, -x.sign};
            y = x.digits == 0 ? x : y;
        }
        x.sign = what == ROOT ? x.sign != 0 : x.sign;
        draw_truth(x_truth, x, stream + 30, i);
        draw_truth(y_truth, y, stream + 40, i);
        wide z = operate(what, x, y);
        if ((what == DIV && y.digits == 0) || (what == ROOT && x.digits == 0 && x.off > 0)) {
            ck_assert_uint_ge(z.off, unknown);
            continue;
        }
        true_operation(what, result, x_truth, y_truth);
        double share = share_of_bound(z, result);
        ck_assert_msg(share <= 1, "%s: %g of the bound, draw %d", names[what], share, (int)i);
        worst = fmax(worst, share);
        known += z.off < unknown;
    }
    printf("%-4s worst error %.3f of its bound, %d of %d known\n", names[what], worst, known,
           DRAWS);
    ck_assert(worst > 0.9);
    ck_assert_int_gt(known, DRAWS / 2);
}

/* Of long numbers the leading digits, of zero all. */
TEST(test_of_exact)
{
    static exact_arena room;
    exact_context c = exact_start(&room);
    for (uint64_t i = 0; i < DRAWS; i++, c.used = 0) {
        exact low = exact_scaled(&c, (int64_t)suite_bits(950, i), suite_integer(951, i, 150));
        exact x = exact_add(&c, exact_scaled(&c, (int64_t)suite_bits(952, i), 0), low);
        wide z = wide_of(exact_mul(&c, x, exact_scaled(&c, i % 100 != 0, 0)));
        if (i % 100 == 0) {
            ck_assert(z.digits == 0 && z.off == 0 && z.sign == 0);
            continue;
        }
        exact half = exact_scaled(&c, (int64_t)(z.digits >> 1), z.exponent + 1);
        exact digits = exact_add(&c, half, exact_scaled(&c, (int64_t)(z.digits & 1), z.exponent));
        exact off = exact_scaled(&c, (int64_t)z.off, z.exponent);
        exact over = exact_sub(&c, z.sign > 0 ? x : exact_negate(&c, x), digits);
        ck_assert(exact_compare(&c, over, off) <= 0);
        ck_assert(exact_compare(&c, exact_negate(&c, over), off) <= 0);
        ck_assert_uint_ge(z.digits, least);
    }
}

/* Halves of digits that a quotient's or root's are hard to tell from; squares, and 1 less. */
static uint64_t draw_halves(uint64_t stream, uint64_t i)
{
    const uint64_t bits = suite_bits(stream, i), half = bits >> 32 | least >> 32;
    const uint64_t ends[] = {0, 1, UINT32_MAX - 1, UINT32_MAX, (uint32_t)bits};
    const uint64_t upper = bits % 3 == 0 ? least >> 32 : bits % 3 == 1 ? UINT32_MAX : half;
    const uint64_t square = half * half - (bits >> 8) % 2;
    return (bits >> 16) % 4 == 0 ? square | least : upper << 32 | ends[(bits >> 3) % 5];
}

/* Of what is off by nothing, a quotient or root is cut by less than 1, a quotient of 63 digits by
 * less than 2. */
LOOP_TEST(test_cut, 2)
{
    const operation what = _i == 0 ? DIV : ROOT;
    TRUE_NUMBERS(WIDE, truth, other, cut);
    for (uint64_t i = 0; i < 10 * DRAWS; i++) {
        const wide x = {draw_halves(700, i), 0, i % 2, 1}, y = {draw_halves(701, i), 0, 0, 1};
        const wide z = operate(what, x, y);
        draw_truth(truth, x, 702, i);
        draw_truth(other, y, 702, i);
        true_operation(what, truth, truth, other);
        mpfr_mul_2si(truth, truth, -z.exponent, MPFR_RNDN);
        set_digits(cut, z.digits);
        mpfr_sub(cut, truth, cut, MPFR_RNDN);
        const unsigned long most = what == DIV && x.digits < y.digits ? 2 : 1;
        ck_assert_msg(mpfr_sgn(cut) >= 0 && mpfr_cmp_ui(cut, most) < 0, "%s: draw %d is off by %g",
                      names[what], (int)i, mpfr_get_d(cut, MPFR_RNDN));
    }
}

/* Of one that is off by so much or more nothing is known, nor of what comes of it. */
TEST(test_unknown)
{
    const wide one = {least, 0, -63, 1}, nothing = wide_div(one, (wide){0, 0, 0, 0});
    double unused;
    exact_context c = {.to_odd = false};
    ck_assert_uint_ge(nothing.off, unknown);
    for (operation what = ADD; what < OPERATIONS; what++) {
        ck_assert_uint_ge(operate(what, nothing, one).off, unknown);
        wide end = {least, unknown - 1, 0, 1};
        ck_assert_uint_ge(operate(what, end, (wide){least, unknown, 0, 1}).off, unknown);
    }
    ck_assert(!wide_rounds(&c, nothing, &unused));
    ck_assert(!wide_rounds(&c, (wide){least, unknown, 2000, 1}, &unused)); /* not infinity */
}

/* All that a number may be rounds as is said, to nearest and to odd, subnormal numbers and those
 * beyond the range, too. */
TEST(test_rounds)
{
    static exact_arena room;
    static const int exponents[] = {-63, -1085, -1130, -1138, -1139, 960, 961};
    int known = 0;
    for (uint64_t i = 0; i < 20 * DRAWS; i++) {
        exact_context c = exact_start(&room);
        c.to_odd = i % 2;
        uint64_t bits = suite_bits(900, i);
        int dropped = (int)(bits % 12);
        wide x = {draw_digits(901, i), suite_bits(902, i) >> (54 + (bits >> 8) % 10),
                  exponents[(bits >> 16) % 7], bits >> 63 ? 1 : -1};
        if ((bits >> 24) % 2 == 0) /* about what parts two doubles */
            x.digits = (x.digits >> dropped << dropped) + ((bits >> 32) % 9) - 4;
        x.digits |= least;
        double said;
        if (!wide_rounds(&c, x, &said))
            continue;
        known++;
        for (int end = -1; end < 2; end++) {
            exact digits = exact_add(&c, exact_scaled(&c, (int64_t)(x.digits >> 1), x.exponent + 1),
                                     exact_scaled(&c, (int64_t)(x.digits & 1), x.exponent));
            exact whole = exact_add(&c, digits, exact_scaled(&c, end * (int64_t)x.off, x.exponent));
            double truth = exact_quotient(&c, x.sign > 0 ? whole : exact_negate(&c, whole),
                                          exact_scaled(&c, 1, 0));
            ck_assert_msg(bits_of(truth) == bits_of(said), "%a, not %a: draw %d", truth, said,
                          (int)i);
        }
    }
    printf("%d of %d known\n", known, 20 * DRAWS);
    ck_assert_int_gt(known, 4 * DRAWS);
}

SUITE("wide")
