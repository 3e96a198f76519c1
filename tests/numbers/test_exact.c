/* SPDX-License-Identifier: MIT */
#include "suite.h"
#include "surroundings.h"
#include "true_number.h"

#include "../../src/numbers/bits.h"
#include "../../src/numbers/exact.h"

#include <signal.h>

/* Results have to be the same in all surroundings. The oracle, GMP's rationals, works in the usual
 * one. */
LOOP_TEST(test_environment, SURROUNDINGS)
{
    volatile double one = 1, small = 0x1p-60, least = DBL_MIN;
    surroundings_set(_i);
    volatile double more = one + small, less = one - small, half = least / 2; /* not later */
    surroundings_set(0);
    enum { UP = 1, DOWN, TOWARD_ZERO };
    int mode = _i % SURROUNDINGS_MODES;
    ck_assert_int_eq(more > 1, mode == UP);
    ck_assert_int_eq(less < 1, mode == DOWN || mode == TOWARD_ZERO);
    ck_assert_int_eq(half > 0, _i < SURROUNDINGS_MODES);
}

/* Allocations are counted where malloc can be replaced. */
static long allocations;
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) ||                         \
    __has_feature(thread_sanitizer)
#define SANITIZED
#endif
#endif
#if defined(__GLIBC__) && !defined(SANITIZED) && !defined(__SANITIZE_ADDRESS__) &&                 \
    !defined(__SANITIZE_THREAD__)
#define COUNTS_ALLOCATIONS
#define COUNTED(name, parameters, ...)                                                             \
    void *__libc_##name parameters;                                                                \
    void *name parameters                                                                          \
    {                                                                                              \
        allocations++;                                                                             \
        return __libc_##name(__VA_ARGS__);                                                         \
    }
COUNTED(malloc, (size_t size), size)
COUNTED(calloc, (size_t count, size_t size), count, size)
COUNTED(realloc, (void *old, size_t size), old, size)
#endif

static exact_arena room;
static exact_context context;

/* Draws of the running test. */
static uint64_t stream, drawn;

static void begin(int number, int environment)
{
    context = exact_start(&room);
    stream = 0x6578616374 + (uint64_t)(16 * number + environment);
    drawn = 0;
}

static uint64_t draw(void)
{
    return suite_bits(stream, drawn++);
}

static int below(int limit)
{
    return (int)(draw() % (uint64_t)limit);
}

/* x as a rational; fails unless x is trimmed. */
static void value_of(mpq_t value, exact x)
{
    mpq_set_ui(value, 0, 1);
    if (x.sign == 0) {
        ck_assert_int_eq(x.size, 0);
        return;
    }
    ck_assert(x.sign == 1 || x.sign == -1);
    ck_assert_int_gt(x.size, 0);
    ck_assert(x.limbs[0] != 0 && x.limbs[x.size - 1] != 0);
    mpz_import(mpq_numref(value), (size_t)x.size, -1, sizeof *x.limbs, 0, 0, x.limbs);
    shift(value, EXACT_LIMB_BITS * x.exponent);
    if (x.sign < 0)
        mpq_neg(value, value);
}

/* Of p and q. */
static void expect(const char *what, exact result, mpq_t wanted, mpq_t p, mpq_t q)
{
    TRUE_RATIONALS(got);
    value_of(got, result);
    if (!mpq_equal(got, wanted)) {
        gmp_fprintf(stderr, "%s of %Qx and %Qx:\n%Qx, expected\n%Qx\n", what, p, q, got, wanted);
        ck_abort_msg("%s in draw %lu", what, (unsigned long)drawn);
    }
}

/* Ends not 0, between them what makes carries run and stop. */
static exact draw_exact(void)
{
    static const int sizes[16] = {1, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 5, 7, 9, 17, 40};
    int size = sizes[below(16)], kind = below(4);
    exact_limb *limbs = context.limbs + context.used;
    for (int i = 0; i < size; i++) {
        const exact_limb special[4] = {0, 1, (exact_limb)1 << (EXACT_LIMB_BITS - 1),
                                       ~(exact_limb)0};
        limbs[i] = kind == 0 ? ~(exact_limb)0 : kind == 1 ? special[below(4)] : (exact_limb)draw();
    }
    if (kind == 2)
        limbs[size - 1] = (exact_limb)(1 + draw() % 3);
    limbs[0] = limbs[0] == 0 ? 1 : limbs[0];
    limbs[size - 1] = limbs[size - 1] == 0 ? 1 : limbs[size - 1];
    context.used += (size_t)size;
    int exponent = below(8) == 0 ? below(400) - 200 : below(7) - 3;
    return (exact){limbs, exponent, (int16_t)size, draw() & 1 ? 1 : -1};
}

/* Independent of x, or so near that they cancel; 0 now and then. */
static exact draw_second(exact x)
{
    int kind = below(8);
    if (kind >= 4 || x.sign == 0)
        return kind == 7 && below(4) == 0 ? (exact){0} : draw_exact();
    exact y = x;
    if (kind == 0 && x.limbs[x.size / 2] != 0) { /* x's own limbs, not all of them */
        y.size = (int16_t)(x.size / 2 + 1);
        return y;
    }
    y.limbs = context.limbs + context.used;
    for (int i = 0; i < x.size; i++)
        y.limbs[i] = x.limbs[i];
    context.used += (size_t)x.size;
    int at = below(x.size);
    exact_limb changed = y.limbs[at] + (draw() & 1 ? 1 : ~(exact_limb)0);
    if (kind == 1 && changed != 0)
        y.limbs[at] = changed;
    if (kind == 2) /* the same above, nothing below */
        for (y.limbs += at, y.size = (int16_t)(y.size - at), y.exponent += at; *y.limbs == 0;
             y.limbs++, y.size--)
            y.exponent++;
    if (kind == 3) /* the least that is more than x's part */
        y = (exact){y.limbs, y.exponent + y.size, 1, y.sign}, y.limbs[0] = 1;
    y.sign = draw() & 1 ? 1 : -1;
    return y;
}

LOOP_TEST(test_operations, SURROUNDINGS)
{
    TRUE_RATIONALS(p, q, wanted);
    begin(1, _i);
    for (int i = 0; i < 8000; i++) {
        exact_release(&context, 0);
        exact x = below(64) == 0 ? (exact){0} : draw_exact(), y = draw_second(x);
        surroundings_set(_i);
        exact sum = exact_add(&context, x, y), difference = exact_sub(&context, x, y);
        exact product = exact_mul(&context, x, y), square = exact_mul(&context, x, x);
        exact negative = exact_negate(&context, x);
        int order = exact_compare(&context, x, y), sign = exact_sign(&context, x);
        surroundings_set(0);
        value_of(p, x);
        value_of(q, y);
        mpq_add(wanted, p, q);
        expect("sum", sum, wanted, p, q);
        mpq_sub(wanted, p, q);
        expect("difference", difference, wanted, p, q);
        ck_assert_int_eq(order, mpq_sgn(wanted));
        mpq_mul(wanted, p, q);
        expect("product", product, wanted, p, q);
        mpq_mul(wanted, p, p);
        expect("square", square, wanted, p, q);
        mpq_neg(wanted, p);
        expect("negative", negative, wanted, p, q);
        ck_assert_int_eq(sign, mpq_sgn(p));
        ck_assert(!context.uncertain);
    }
}

/* A finite double; every exponent is as likely, those at the ends more. */
static double draw_double(void)
{
    static const uint64_t exponents[4] = {0, 1, 0x7fe, 0x3ff};
    uint64_t exponent = below(4) == 0 ? exponents[below(4)] : draw() % 0x7ff;
    uint64_t fraction = draw() >> 12;
    int kind = below(8);
    if (kind < 3)
        fraction = kind == 0 ? 0 : kind == 1 ? UINT64_C(0xfffffffffffff) : fraction & 1;
    return double_of(draw() >> 63 << 63 | exponent << 52 | fraction);
}

LOOP_TEST(test_doubles, SURROUNDINGS)
{
    TRUE_RATIONALS(wanted);
    begin(2, _i);
    for (int i = 0; i < 5000; i++) {
        exact_release(&context, 0);
        double x = draw_double();
        surroundings_set(_i);
        exact number = exact_of(&context, x);
        double back = exact_quotient(&context, number, exact_scaled(&context, 1, 0));
        surroundings_set(0);
        mpq_set_d(wanted, x);
        expect("double", number, wanted, wanted, wanted);
        ck_assert_int_le(number.size, 64 / EXACT_LIMB_BITS + 1);
        ck_assert(bits_of(back) == bits_of(x == 0 ? 0 : x));
    }
}

LOOP_TEST(test_scaled, SURROUNDINGS)
{
    static const int64_t mantissas[6] = {0, 1, -1, INT64_MAX, INT64_MIN, INT64_MIN + 1};
    TRUE_RATIONALS(wanted);
    begin(3, _i);
    for (int i = 0; i < 11000; i++) {
        exact_release(&context, 0);
        int64_t mantissa = i % 2 == 0 ? mantissas[i / 2 % 6] : (int64_t)draw();
        int exponent = i < 10001 ? i - 5000 : below(10001) - 5000;
        surroundings_set(_i);
        exact number = exact_scaled(&context, mantissa, exponent);
        surroundings_set(0);
        mpq_set_si(wanted, (long)mantissa, 1);
        shift(wanted, exponent);
        expect("scaled", number, wanted, wanted, wanted);
    }
}

/* By the definition. */
LOOP_TEST(test_top, SURROUNDINGS)
{
    TRUE_RATIONALS(size, low, high);
    begin(4, _i);
    for (int i = 0; i < 5000; i++) {
        exact_release(&context, 0);
        exact x = draw_exact();
        if (i % 3 == 0)
            x = exact_mul(&context, x, exact_scaled(&context, 1, below(64)));
        int exponent = 0;
        surroundings_set(_i);
        uint64_t bits = exact_top(x, &exponent);
        surroundings_set(0);
        ck_assert(bits >> 63 == 1);
        value_of(size, x);
        mpq_abs(size, size);
        mpz_import(mpq_numref(low), 1, -1, sizeof bits, 0, 0, &bits);
        mpz_set_ui(mpq_denref(low), 1);
        mpz_add_ui(mpq_numref(high), mpq_numref(low), 1);
        mpz_set_ui(mpq_denref(high), 1);
        shift(low, exponent);
        shift(high, exponent);
        ck_assert(mpq_cmp(size, low) >= 0 && mpq_cmp(size, high) < 0);
    }
}

/* The magnitude whose bits these are; what would come after DBL_MAX is 2^1024. */
static void magnitude_of(mpq_t value, uint64_t bits)
{
    if (bits < BITS_INFINITY) {
        mpq_set_d(value, double_of(bits));
        return;
    }
    mpq_set_ui(value, 1, 1);
    shift(value, 1024);
}

/* Is x the double nearest to p/q? The quotient lies between the points halfway to x's neighbours,
 * or on one when x's last bit is 0. */
static bool nearest(double x, mpq_t p, mpq_t q)
{
    TRUE_RATIONALS(quotient, at, side);
    mpq_div(quotient, p, q);
    int sign = mpq_sgn(quotient);
    mpq_abs(quotient, quotient);
    mpq_mul_2exp(quotient, quotient, 1);
    uint64_t bits = bits_of(x), magnitude = bits << 1 >> 1;
    int tie = (magnitude & 1) == 0 ? 0 : 1;
    bool right = bits >> 63 == (sign < 0 && magnitude != 0) && magnitude <= BITS_INFINITY;
    magnitude_of(at, magnitude);
    for (int up = 0; up < 2 && right; up++) {
        if (magnitude == (up ? BITS_INFINITY : 0))
            continue;
        magnitude_of(side, up ? magnitude + 1 : magnitude - 1);
        mpq_add(side, side, at);
        int beyond = mpq_cmp(quotient, side) * (up ? -1 : 1);
        right = (beyond > 0) - (beyond < 0) >= tie;
    }
    return right;
}

static void expect_quotient(int environment, exact n, exact d)
{
    TRUE_RATIONALS(p, q);
    size_t mark = exact_mark(&context);
    surroundings_set(environment);
    double x = exact_quotient(&context, n, d);
    surroundings_set(0);
    ck_assert(exact_mark(&context) == mark);
    value_of(p, n);
    value_of(q, d);
    if (!nearest(x, p, q)) {
        gmp_fprintf(stderr, "%Qx\nover\n%Qx\n", p, q);
        ck_abort_msg("draw %lu: the quotient is not %a", (unsigned long)drawn, x);
    }
}

LOOP_TEST(test_quotients, SURROUNDINGS)
{
    begin(5, _i);
    for (int i = 0; i < 5000; i++) {
        exact_release(&context, 0);
        exact d = i % 4 == 0 ? exact_of(&context, 0x1p-3 * (1 + below(99))) : draw_exact();
        exact n = i % 4 == 0 ? exact_of(&context, below(99) - 49) : draw_second(d);
        /* Most of the others are in the range of doubles. */
        if (i % 4 == 1)
            n.exponent = d.exponent + d.size - n.size + below(33) - 17;
        expect_quotient(_i, n, d);
    }
}

/* Quotients at and next to every kind of limit: halfway points and doubles, from the least
 * subnormal's half to the greatest double's next, over any d. */
LOOP_TEST(test_ties, SURROUNDINGS)
{
    begin(6, _i);
    for (int i = 0; i < 5000; i++) {
        exact_release(&context, 0);
        double x = fabs(draw_double());
        int last = 0;
        frexp(x, &last);
        last = (x < DBL_MIN ? -1073 : last) - 53; /* the last bit's exponent */
        exact half = exact_scaled(&context, below(3) - 1, last - 1);
        exact limit = exact_add(&context, exact_of(&context, draw() & 1 ? x : -x), half);
        exact d = draw_exact();
        exact n = exact_mul(&context, limit, d);
        if (i % 2 == 0) /* the least bit that can decide, far below or just below */
            n = exact_add(&context, n,
                          exact_scaled(&context, draw() & 1 ? 1 : -1,
                                       EXACT_LIMB_BITS * d.exponent + last - 1 - below(300)));
        expect_quotient(_i, n, d);
    }
}

LOOP_TEST(test_thresholds, SURROUNDINGS)
{
    begin(7, _i);
    exact one = exact_scaled(&context, 1, 0), least_half = exact_scaled(&context, 1, -1075);
    exact beyond = exact_scaled(&context, (INT64_C(1) << 54) - 1, 970);
    exact grain = exact_scaled(&context, 1, -5000);
    exact under = exact_sub(&context, beyond, grain), over = exact_add(&context, least_half, grain);
    surroundings_set(_i);
    double results[] = {
        exact_quotient(&context, exact_sub(&context, one, one), one),
        exact_quotient(&context, one, exact_sub(&context, one, one)),
        exact_quotient(&context, least_half, one),
        exact_quotient(&context, over, one),
        exact_quotient(&context, beyond, one),
        exact_quotient(&context, under, one),
        exact_quotient(&context, exact_scaled(&context, -1, 5000), grain),
        exact_quotient(&context, grain, exact_scaled(&context, -1, 5000)),
        exact_quotient(&context, exact_negate(&context, least_half), one),
    };
    surroundings_set(0);
    const double wanted[] = {0, 0, 0, 0x1p-1074, INFINITY, DBL_MAX, -INFINITY, 0, 0};
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++)
        ck_assert_msg(bits_of(results[k]) == bits_of(wanted[k]), "%zu: %a", k, results[k]);
}

/* From the least bit to the greatest: no number can have more limbs than the arena's count says,
 * degree by degree, and nothing is allocated for them. */
LOOP_TEST(test_longest, SURROUNDINGS)
{
    begin(8, _i);
    exact least = exact_of(&context, 0x1p-1074);
    exact widest = exact_sub(&context, exact_of(&context, DBL_MAX), least);
    ck_assert_int_eq(widest.size, 33 * 64 / EXACT_LIMB_BITS);
    widest = exact_sub(&context, exact_of(&context, DBL_MAX), exact_of(&context, -DBL_MAX));
    widest = exact_sub(&context, widest, least); /* longer than a difference can be */
    ck_assert_int_le(widest.size, EXACT_DEGREE_LIMBS);
    static exact_limb kept[32 * EXACT_DEGREE_LIMBS];
    size_t mark = exact_mark(&context);
    TRUE_RATIONALS(base, wanted);
    value_of(base, widest);
    mpq_set(wanted, base);
    exact power = widest;
    for (int degree = 2; degree <= 32; degree++) {
        long before = allocations;
        surroundings_set(_i);
        exact next = exact_mul(&context, power, widest);
        exact square = exact_mul(&context, power, power);
        exact product = exact_mul(&context, next, power);
        exact other = exact_sub(&context, product, exact_mul(&context, square, widest));
        double ratio = exact_quotient(&context, product, square);
        double inverse = exact_quotient(&context, widest, product);
        double same = exact_quotient(&context, next, next);
        surroundings_set(0);
        ck_assert_int_eq(allocations, before);
        ck_assert_int_eq(other.sign, 0);
        ck_double_same(ratio, INFINITY); /* more than 2^1024 */
        ck_double_same(inverse, 0);      /* less than 2^-2050 */
        ck_double_same(same, 1);
        ck_assert_int_le(next.size, EXACT_DEGREE_LIMBS * degree);
        mpq_mul(wanted, wanted, base);
        expect("power", next, wanted, wanted, wanted);
        memcpy(kept, next.limbs, (size_t)next.size * sizeof *kept);
        exact_release(&context, mark);
        power = next;
        power.limbs = kept;
    }
}

#ifdef COUNTS_ALLOCATIONS
TEST(test_counter)
{
    long before = allocations;
    mpz_t number;
    mpz_init2(number, 64);
    mpz_mul_2exp(number, number, 5000);
    mpz_setbit(number, 5000);
    mpz_clear(number);
    ck_assert_int_gt(allocations, before);
}
#endif

TEST(test_marks)
{
    begin(9, 0);
    exact first = exact_scaled(&context, 3, 0);
    size_t mark = exact_mark(&context);
    exact_scaled(&context, 9, 9);
    exact_release(&context, mark);
    ck_assert(exact_mark(&context) == mark);
    TRUE_RATIONALS(three);
    mpq_set_ui(three, 3, 1);
    expect("older", first, three, three, three);
}

/* Filled up to the last limb, and not a limb more. */
enum { SUM_LIMBS = 128 / EXACT_LIMB_BITS + 2 };

static void fill(size_t left)
{
    begin(10, 0);
    exact x = exact_scaled(&context, -1, 0), y = exact_scaled(&context, 1, 128);
    context.used = context.capacity - left;
    exact_add(&context, x, y);
}

TEST(test_full)
{
    fill(SUM_LIMBS);
}

SIGNAL_TEST(test_overfull, SIGABRT)
{
    fill(SUM_LIMBS - 1);
}

SUITE("exact")
