/* SPDX-License-Identifier: MIT */
/* Each operation of ddb.h, on operands of every kind that its invariant admits: is the true result
 * within the bound? Everything true is an MPFR number wide enough to be exact. */
#include "../support/surroundings.h"

#include "../../src/numbers/ddb.h"

#define NUMBER ddb
#define LEADING(x) (x).hi
#include "operations.h"

enum { DRAWS = 10000, WIDE = 6000 };

/* What is drawn: magnitudes about 1, without errors and with; far apart; where products underflow;
 * where everything does. */
typedef enum { EXACT, ROUNDED, SPREAD, SMALL, TINY, KINDS } kind;
static const char *const kinds[KINDS] = {"exact", "rounded", "spread", "small", "tiny"};

static double fraction(uint64_t stream, uint64_t index)
{
    return suite_double(stream, index, 0);
}

/* An operand and the number that it stands for. */
typedef struct {
    ddb rounded;
    mpfr_t truth;
} operand;

static int draw_exponent(kind of, uint64_t stream, uint64_t i)
{
    switch (of) {
    case SPREAD: return suite_integer(stream, i, 300);
    case SMALL: return suite_integer(stream, i, 30) - 500;
    case TINY: return suite_integer(stream, i, 45) - 975;
    default: return suite_integer(stream, i, 2);
    }
}

/* Any number that the invariant admits. */
static ddb draw_near(kind of, uint64_t stream, uint64_t i)
{
    unsigned choice = (unsigned)(suite_bits(stream, i) % 8);
    if (choice == 0 && suite_integer(stream + 1, i, 8) == 0)
        return (ddb){0, 0, 0};
    int exponent = draw_exponent(of, stream + 2, i);
    ddb x = {significand(suite_bits(stream + 3, i)) * power_of_two(exponent), 0, 0};
    x.hi = suite_bits(stream + 4, i) % 2 ? x.hi : -x.hi;
    if (choice > 1)
        x.lo = (choice == 2 ? 1 : fraction(stream + 5, i)) *
               power_of_two(exponent > -960 ? exponent - 53 : -1022);
    if (choice > 4 && of != EXACT)
        x.error = fabs(x.hi * fraction(stream + 6, i)) *
                  power_of_two(suite_integer(stream + 7, i, 60) - 60);
    if (of >= SMALL && x.error < DDB_FLOOR)
        x.error = DDB_FLOOR * (1 + fabs(fraction(stream + 8, i)));
    if (choice > 6 && of != EXACT)
        x.lo = fraction(stream + 9, i) * 0x1p-12 * x.error;
    return x;
}

/* The truth is x.hi + x.lo + part x.error, a part in [-1, 1]: often an end. */
static void draw_truth(mpfr_t truth, ddb x, uint64_t stream, uint64_t i)
{
    static const double ends[] = {-1, 0, 1};
    uint64_t choice = suite_bits(stream, i) % 4;
    double part = choice < 3 ? ends[choice] : fraction(stream + 1, i);
    exactly(mpfr_set_d(truth, x.error, MPFR_RNDN));
    exactly(mpfr_mul_d(truth, truth, part, MPFR_RNDN));
    exactly(mpfr_add_d(truth, truth, x.hi, MPFR_RNDN));
    exactly(mpfr_add_d(truth, truth, x.lo, MPFR_RNDN));
}

/* The operands of draw i; a quarter cancel, but for a few bits. */
static void draw(operation what, kind of, uint64_t i, operand *x, operand *y)
{
    uint64_t stream = 1000 * (uint64_t)what + 100 * (uint64_t)of;
    x->rounded = draw_near(of, stream, i);
    y->rounded = draw_near(of, stream + 20, i);
    if (suite_bits(stream + 40, i) % 4 == 0 && x->rounded.hi != 0) {
        y->rounded = x->rounded;
        y->rounded.hi = cancelling(what, x->rounded.hi, suite_bits(stream + 41, i));
    }
    if (what == ROOT && x->rounded.hi < 0)
        x->rounded = ddb_negate(NULL, x->rounded);
    bool doubles = what == SUM || what == DIFFERENCE;
    ddb double_x = {x->rounded.hi, 0, 0}, double_y = {y->rounded.hi, 0, 0};
    draw_truth(x->truth, doubles ? double_x : x->rounded, stream + 42, i);
    draw_truth(y->truth, doubles ? double_y : y->rounded, stream + 44, i);
}

/* The distance of z from the true result, which is lost, over what it may be. */
static double share_of_error(mpfr_t true_result, ddb z)
{
    TRUE_NUMBERS(WIDE, bound);
    mpfr_sub_d(true_result, true_result, z.hi, MPFR_RNDN);
    mpfr_sub_d(true_result, true_result, z.lo, MPFR_RNDN);
    bool right = mpfr_zero_p(true_result) != 0;
    mpfr_set_d(bound, z.error, MPFR_RNDN);
    mpfr_div(bound, true_result, bound, MPFR_RNDA);
    return right ? 0 : fabs(mpfr_get_d(bound, MPFR_RNDA));
}

/* The same by an operation. Quotients and roots are rounded, to WIDE bits. */
static double share_of_bound(operation what, operand *x, operand *y, ddb z)
{
    TRUE_NUMBERS(WIDE, true_result);
    true_operation(what, true_result, x->truth, y->truth);
    return share_of_error(true_result, z);
}

static bool on_grid(double x)
{
    magnitude_parts parts = parts_of(x);
    return parts.exponent >= -1022 || parts.mantissa << (64 - (-1022 - parts.exponent)) == 0;
}

static void check_invariant(ddb z)
{
    bool finite = is_finite_bits(z.hi) && is_finite_bits(z.lo) && is_finite_bits(z.error);
    bool normal = fabs(z.lo) <= 0x1p-53 * fabs(z.hi) + 0x1p-12 * z.error;
    bool safe = z.error >= DDB_FLOOR || (on_grid(z.hi) && on_grid(z.lo));
    if (!finite || !normal || !safe)
        ck_abort_msg("%a + %a +- %a", z.hi, z.lo, z.error);
}

/* Is x so close to zero that its sign may be left open? */
static bool is_doubtful(ddb x)
{
    return fabs(x.hi) <= 1.01 * x.error;
}

/* What is told must be so, and what is left open must be doubtful. */
static void check_sign(const operand *x)
{
    ddb_context context = {false};
    int sign = ddb_sign(&context, x->rounded), truth = mpfr_sgn(x->truth);
    bool told = context.uncertain ? is_doubtful(x->rounded) : sign == (truth > 0) - (truth < 0);
    if (!told)
        ck_abort_msg("sign %d, uncertain %d, of %a + %a +- %a", sign, context.uncertain,
                     x->rounded.hi, x->rounded.lo, x->rounded.error);
}

static void exceeded(operation what, kind of, int flushed, uint64_t i, double share, ddb x, ddb y)
{
    ck_abort_msg("%s, %s, flushed %d, draw %d: %g of the bound\n"
                 "x = %a + %a +- %a, y = %a + %a +- %a",
                 names[what], kinds[of], flushed, (int)i, share, x.hi, x.lo, x.error, y.hi, y.lo,
                 y.error);
}

/* The worst share of the bound that is found, at most 1. */
static double worst_share(operation what, kind of, int flushed)
{
    operand x, y;
    mpfr_inits2(WIDE, x.truth, y.truth, (mpfr_ptr)NULL);
    const uint64_t share_of_draws = suite_setting("SUREHIT_SHARE", 1);
    double worst = 0;
    int uncertain = 0;
    for (uint64_t i = 0; i < DRAWS; i += share_of_draws) {
        draw(what, of, i, &x, &y);
        if (what != SUM && what != DIFFERENCE)
            check_sign(&x);
        ddb_context context = {false};
        ddb z = (flushed ? operate_flushed : operate)(&context, what, x.rounded, y.rounded);
        if (context.uncertain) {
            ddb doubtful = what == DIV ? y.rounded : x.rounded;
            if (!(what == DIV || what == ROOT) || !is_doubtful(doubtful))
                ck_abort_msg("%s of %a + %a +- %a", names[what], doubtful.hi, doubtful.lo,
                             doubtful.error);
            uncertain++;
            continue;
        }
        check_invariant(z);
        double share = share_of_bound(what, &x, &y, z);
        if (!(share <= 1))
            exceeded(what, of, flushed, i, share, x.rounded, y.rounded);
        worst = fmax(worst, share);
    }
    ck_assert_int_lt(uncertain, (int)(DRAWS / 2 / share_of_draws));
    mpfr_clears(x.truth, y.truth, (mpfr_ptr)NULL);
    return worst;
}

/* No bound is exceeded, and none is idle: of exact operands the roundings alone reach an
 * eighth. */
LOOP_TEST(test_bounds, OPERATIONS)
{
    for (kind of = EXACT; of < KINDS; of++) {
        for (int flushed = 0; flushed < 2; flushed++) {
            double worst = worst_share((operation)_i, of, flushed);
            printf("%-10s %-7s %-8s worst error %.3f of its bound\n", names[_i], kinds[of],
                   flushed ? "flushed" : "", worst);
            if (of == EXACT && _i != SUM && _i != DIFFERENCE)
                ck_assert(worst > 0.125);
        }
    }
}

static ddb (*volatile along)(double, double, double, double) = ddb_along;

/* x - y + a b; in most draws a b cancels all but the last bits of x - y. */
static void draw_along(kind of, uint64_t i, double v[4])
{
    const uint64_t stream = 7000 + 100 * (uint64_t)of;
    for (uint64_t k = 0; k < 4; k++)
        v[k] = suite_double(stream + k, i, 0) * power_of_two(draw_exponent(of, stream + 10 + k, i));
    const uint64_t choice = suite_bits(stream + 20, i) % 8;
    if (choice > 2)
        v[3] = (v[1] - v[0]) / v[2];
    if (choice == 0)
        v[2 + i % 2] = 0;
    if (choice == 1 || choice == 7)
        v[1] = choice == 1 ? v[0] : 0;
}

/* Only roundings make ddb_along's error, and they count for what is left of the sum. */
TEST(test_along)
{
    TRUE_NUMBERS(WIDE, truth, product);
    for (int row = 0; row < 2 * KINDS; row++) {
        const kind of = (kind)(row / 2);
        double worst = 0, v[4];
        int near = 0;
        for (uint64_t i = 0; i < DRAWS; i++) {
            draw_along(of, i, v);
            surroundings_set(row % 2 ? SURROUNDINGS_MODES : 0);
            const ddb z = along(v[0], v[1], v[2], v[3]);
            surroundings_set(0);
            check_invariant(z);
            exactly(mpfr_set_d(truth, v[0], MPFR_RNDN));
            exactly(mpfr_sub_d(truth, truth, v[1], MPFR_RNDN));
            exactly(mpfr_set_d(product, v[2], MPFR_RNDN));
            exactly(mpfr_mul_d(product, product, v[3], MPFR_RNDN));
            exactly(mpfr_add(truth, truth, product, MPFR_RNDN));
            const double share = share_of_error(truth, z);
            ck_assert_msg(share <= 1, "%s, draw %d: %g of the bound", kinds[of], (int)i, share);
            worst = fmax(worst, share);
            near += z.error <= 0x1p-103 * fabs(z.hi);
        }
        printf("along %-7s worst error %.3f of its bound, %d near\n", kinds[of], worst, near);
        ck_assert(of >= SMALL || (worst > 0.125 && near > DRAWS * 9 / 10));
    }
}

static double draw_subnormal(uint64_t stream, uint64_t i)
{
    return double_of(suite_bits(stream, i) & (BITS_SIGN | BITS_FRACTION));
}

/* Subnormals given as doubles: flushed to zero, their bound still tells. */
TEST(test_subnormals)
{
    static const operation any[] = {SUM, DIFFERENCE, ADD, SUB, MUL};
    operand x, y;
    mpfr_inits2(WIDE, x.truth, y.truth, (mpfr_ptr)NULL);
    for (uint64_t i = 0; i < DRAWS; i++) {
        operation what = any[i % 5];
        double large = suite_double(60, i, 900), small = draw_subnormal(61, i);
        x.rounded = ddb_of(NULL, suite_bits(63, i) % 2 ? draw_subnormal(62, i) : large);
        y.rounded = ddb_of(NULL, small);
        exactly(mpfr_set_d(x.truth, x.rounded.hi, MPFR_RNDN));
        exactly(mpfr_set_d(y.truth, small, MPFR_RNDN));
        check_sign(&x);
        ddb z = operate_flushed(NULL, what, x.rounded, y.rounded);
        double share = share_of_bound(what, &x, &y, z);
        if (!(share <= 1))
            exceeded(what, TINY, 1, i, share, x.rounded, y.rounded);
    }
    mpfr_clears(x.truth, y.truth, (mpfr_ptr)NULL);
}

static int sign_of(ddb x)
{
    ddb_context context = {false};
    int sign = ddb_sign(&context, x);
    return context.uncertain ? 2 : sign;
}

/* A zero is certain where nothing was rounded, and as a factor; an equal rounded result is not. */
TEST(test_zeros)
{
    ddb_context context = {false};
    ddb zero = ddb_difference_of(&context, 0.1, 0.1), minus = ddb_of(&context, -0.0);
    ddb third = ddb_div(&context, ddb_of(&context, 1), ddb_of(&context, 3));
    ck_assert(!context.uncertain);
    ck_assert_int_eq(sign_of(zero), 0);
    ck_assert_int_eq(sign_of(minus), 0);
    ck_assert_int_eq(sign_of(ddb_mul(&context, zero, third)), 0);
    ck_assert_int_eq(sign_of(ddb_mul(&context, third, minus)), 0);
    ck_assert_int_eq(sign_of(ddb_square(&context, zero)), 0);
    ck_assert_int_eq(sign_of(ddb_div(&context, zero, third)), 0);
    ck_assert_int_eq(sign_of(ddb_sqrt(&context, zero)), 0);
    ck_assert(!context.uncertain);
    ck_assert_int_eq(sign_of(ddb_sub(&context, third, third)), 2);
    ddb small = ddb_square(&context, ddb_of(&context, 0x1p-600));
    ck_assert_int_eq(sign_of(small), 2);
    ck_assert_int_eq(sign_of(ddb_mul(&context, small, ddb_of(&context, 0x1p+900))), 2);
    (void)ddb_div(&context, third, zero);
    ck_assert(context.uncertain);
    context.uncertain = false;
    (void)ddb_sqrt(&context, ddb_of(&context, -1));
    ck_assert(context.uncertain);
    (void)ddb_sqrt(&context, ddb_of(&context, 1));
    ck_assert(context.uncertain);
}

/* What overflowed has no sign, nor has anything made of it; not even nothing times it. */
TEST(test_overflow)
{
    ddb_context context = {false};
    ddb one = ddb_of(&context, 1), huge = ddb_of(&context, 0x1p+1000);
    ddb gone[] = {ddb_mul(&context, huge, huge), ddb_square(&context, huge),
                  ddb_sum_of(&context, DBL_MAX, DBL_MAX),
                  ddb_add(&context, ddb_of(&context, DBL_MAX), ddb_of(&context, DBL_MAX)),
                  ddb_div(&context, huge, ddb_of(&context, 0x1p-900))};
    ck_assert(!context.uncertain);
    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++) {
        ddb next[] = {gone[i],
                      ddb_negate(&context, gone[i]),
                      ddb_add(&context, one, gone[i]),
                      ddb_sub(&context, gone[i], gone[i]),
                      ddb_mul(&context, gone[i], one),
                      ddb_mul(&context, ddb_of(&context, 0), gone[i]),
                      ddb_square(&context, gone[i])};
        for (size_t k = 0; k < sizeof next / sizeof *next; k++)
            ck_assert_msg(sign_of(next[k]) == 2, "%d, %d", (int)i, (int)k);
        (void)ddb_sqrt(&context, gone[i]);
        ck_assert(context.uncertain);
        context.uncertain = false;
        ddb inverse = ddb_div(&context, one, gone[i]);
        ck_assert(context.uncertain || sign_of(inverse) == 2);
        context.uncertain = false;
    }
}

SUITE("ddb")
