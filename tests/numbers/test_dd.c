/* SPDX-License-Identifier: MIT */
/* Each operation of dd.h, on operands with tails as long as its callers leave them: is the result
 * within what docs/proofs/dd.md counts, and so within DD_SHARE of a rounding? Everything true
 * is an MPFR number wide enough to be exact, quotients and roots excepted. */
#include "../support/surroundings.h"

#include "../../src/numbers/dd.h"

#define NUMBER dd
#define LEADING(x) (x).head
#include "operations.h"

enum { DRAWS = 20000, CLIMBS = 40, STEPS = 800, WIDE = 1600 };

/* Tails of at most so many 2^-53 of the head, and the count that they lead to: of 2^-106 times the
 * result, or for sums the sum of magnitudes. */
typedef struct {
    operation what;
    int tail_x, tail_y;
    double count;
} promise;

#define LARGEST 28.01 /* count */

static const promise promises[] = {
    {DIFFERENCE, 0, 0, 0}, {ADD, 1, 1, 3.01},     {ADD, 3, 3, 7.01},  {ADD, 5, 5, 11.01},
    {SUB, 5, 5, 11.01},    {MUL, 1, 1, 8.01},     {MUL, 1, 3, 16.01}, {MUL, 3, 3, LARGEST},
    {SQUARE, 1, 1, 7.01},  {SQUARE, 3, 3, 19.01}, {DIV, 1, 1, 20},    {ROOT, 1, 1, 5},
    {ROOT, 3, 3, 17}};
enum { PROMISES = sizeof promises / sizeof *promises };

/* What all that underflows in one operation is less than, when nothing divides it. */
#define FLOOR 0x1p-1016

/* A head of that exponent, and a tail that is often as long as it may be. */
static dd draw_pair(int tail, int exponent, uint64_t stream, uint64_t i)
{
    double head = significand(suite_bits(stream, i)) * power_of_two(exponent);
    double part = suite_bits(stream + 1, i) % 4 == 0 ? 1 : suite_double(stream + 2, i, 0);
    dd x = {suite_bits(stream + 3, i) % 2 ? head : -head, tail * 0x1p-53 * head * part};
    if (suite_bits(stream + 4, i) % 16 == 0)
        x.tail = 0;
    return x;
}

typedef struct {
    dd x, y;
} operands;

/* Of like size; far apart; where products underflow. A quarter cancel but for a few bits. */
static operands draw(const promise *p, int kind, uint64_t i)
{
    static const int spreads[] = {2, 80, 30};
    uint64_t stream = 100 * (uint64_t)(p - promises) + 2000 * (uint64_t)kind;
    int middle = kind == 2 ? -490 : 0;
    int of_x = suite_integer(stream, i, spreads[kind]) + middle;
    int of_y = suite_integer(stream + 1, i, spreads[kind]) + middle;
    operands o = {draw_pair(p->tail_x, of_x, stream + 2, i),
                  draw_pair(p->tail_y, of_y, stream + 12, i)};
    if (suite_bits(stream + 22, i) % 4 == 0) {
        o.y.head = cancelling(p->what, o.x.head, suite_bits(stream + 23, i));
        o.y.tail = p->tail_y * 0x1p-53 * o.y.head * suite_double(stream + 24, i, 0);
    }
    if (p->what == ROOT && o.x.head < 0)
        o.x = dd_negate(NULL, o.x);
    if (p->what == DIFFERENCE)
        o.x.tail = o.y.tail = 0;
    return o;
}

static void set_pair(mpfr_t truth, dd x)
{
    exactly(mpfr_set_d(truth, x.head, MPFR_RNDN));
    exactly(mpfr_add_d(truth, truth, x.tail, MPFR_RNDN));
}

/* The true result, and the magnitude that its error is a share of. */
static void true_result(operation what, mpfr_t result, mpfr_t magnitude, mpfr_t x, mpfr_t y)
{
    bool sum = what == ADD || what == SUB || what == DIFFERENCE;
    true_operation(what, result, x, y);
    mpfr_abs(magnitude, result, MPFR_RNDN);
    if (sum) {
        mpfr_abs(magnitude, x, MPFR_RNDN);
        (mpfr_sgn(y) < 0 ? mpfr_sub : mpfr_add)(magnitude, magnitude, y, MPFR_RNDN);
    }
}

/* The error over 2^-106 of the magnitude, what may underflow taken off. */
static double count_of(operation what, const operands *o, dd z)
{
    TRUE_NUMBERS(WIDE, x, y, result, magnitude);
    set_pair(x, o->x);
    set_pair(y, o->y);
    true_result(what, result, magnitude, x, y);
    mpfr_sub_d(result, result, z.head, MPFR_RNDN);
    mpfr_sub_d(result, result, z.tail, MPFR_RNDN);
    mpfr_abs(result, result, MPFR_RNDN);
    double per = what == DIV ? fabs(o->y.head) : what == ROOT ? z.head : 1;
    mpfr_sub_d(result, result, fmax(FLOOR / per, FLOOR), MPFR_RNDN);
    mpfr_div(result, result, magnitude, MPFR_RNDN);
    return mpfr_sgn(result) <= 0 ? 0 : 0x1p106 * mpfr_get_d(result, MPFR_RNDU);
}

static double check(const promise *p, const operands *o, bool flushed)
{
    dd z = (flushed ? operate_flushed : operate)(NULL, p->what, o->x, o->y);
    double count = count_of(p->what, o, z);
    if (!(count <= p->count && count * 0x1p-106 <= DD_SHARE * 0x1p-52))
        ck_abort_msg("%s, flushed %d: %g of %g 2^-106; x = %a + %a, y = %a + %a", names[p->what],
                     flushed, count, p->count, o->x.head, o->x.tail, o->y.head, o->y.tail);
    if (!flushed && p->what != MUL && p->what != SQUARE && fabs(z.tail) > 0x1p-53 * fabs(z.head))
        ck_abort_msg("%s leaves a long tail: %a + %a", names[p->what], z.head, z.tail);
    return count;
}

LOOP_TEST(test_counts, PROMISES)
{
    const promise *p = &promises[_i];
    const uint64_t share = suite_setting("SUREHIT_SHARE", 1);
    for (int kind = 0; kind < 3; kind++) {
        double worst = 0;
        for (uint64_t i = 0; i < DRAWS; i += share) {
            operands o = draw(p, kind, i);
            worst = fmax(worst, check(p, &o, false));
            worst = fmax(worst, check(p, &o, true));
        }
        printf("%-10s tails %d %d  kind %d  %6.2f of %g\n", names[p->what], p->tail_x, p->tail_y,
               kind, worst, p->count);
    }
}

/* One of the four numbers with other low bits, tails kept short enough. */
static operands changed(const promise *p, operands o, uint64_t bits)
{
    double *numbers[] = {&o.x.head, &o.y.head, &o.x.tail, &o.y.tail};
    double *x = numbers[bits % (p->what == DIFFERENCE ? 2 : 4)];
    uint64_t mask = suite_bits(90001, bits) >> (13 + suite_bits(90002, bits) % 50);
    *x = *x == 0 ? 0 : double_of(bits_of(*x) ^ mask);
    double most_x = p->tail_x * 0x1p-53 * fabs(o.x.head);
    double most_y = p->tail_y * 0x1p-53 * fabs(o.y.head);
    o.x.tail = fmax(-most_x, fmin(o.x.tail, most_x));
    o.y.tail = fmax(-most_y, fmin(o.y.tail, most_y));
    return o;
}

/* Uphill to the greatest error: none beyond the count, and no operation's count is idle. The worst
 * of all is more than an eighth of what a double-double's rounding stands for. */
LOOP_TEST(test_search, PROMISES)
{
    const promise *p = &promises[_i];
    double worst = 0;
    for (uint64_t climb = 0; climb < CLIMBS; climb++) {
        operands best = draw(p, 0, climb);
        double most = check(p, &best, false);
        for (uint64_t k = 0; k < STEPS; k++) {
            operands next = changed(p, best, suite_bits(90000, climb * STEPS + k));
            double count = check(p, &next, false);
            if (count >= most) {
                most = count;
                best = next;
            }
        }
        worst = fmax(worst, most);
    }
    printf("%-10s tails %d %d  searched %6.2f of %g\n", names[p->what], p->tail_x, p->tail_y, worst,
           p->count);
    ck_assert(worst >= p->count / 4);
    ck_assert(p->count < LARGEST || worst * 0x1p-106 > DD_SHARE * 0x1p-52 / 8);
}

/* What is exact stays so: zeros, differences of doubles, products of few bits. */
TEST(test_exact)
{
    dd third = dd_div(NULL, dd_of(NULL, 1), dd_of(NULL, 3)), zero = dd_of(NULL, 0);
    dd none = dd_sub(NULL, third, third), same = dd_add(NULL, third, zero);
    ck_double_same(none.head, 0);
    ck_double_same(none.tail, 0);
    ck_double_same(same.head, third.head);
    ck_double_same(same.tail, third.tail);
    ck_double_same(dd_mul(NULL, third, zero).head, 0);
    dd square = dd_square(NULL, dd_of(NULL, 0x1.0000001p+0));
    ck_double_same(square.head, 0x1.0000002p+0);
    ck_double_same(square.tail, 0x1p-56);
    dd long_one = dd_difference_of(NULL, 0x1p+60, 0x1p-60);
    ck_double_same(long_one.head, 0x1p+60);
    ck_double_same(long_one.tail, -0x1p-60);
    dd root = dd_sqrt(NULL, square);
    ck_double_same(root.head, 0x1.0000001p+0);
    ck_double_same(root.tail, 0);
}

SUITE("dd")
