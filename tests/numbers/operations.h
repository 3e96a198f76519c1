/* SPDX-License-Identifier: MIT */
/* What the tests of dd and ddb share, one of which is NUMBER here: its operations, the true ones,
 * and significands where bounds are attained. LEADING is the double that is nearly all of a
 * number. */
#pragma once

#include "../support/suite.h"
#include "../support/true_number.h"

#include "../../src/numbers/number.h"

typedef enum { ADD, SUB, MUL, SQUARE, SUM, DIFFERENCE, DIV, ROOT, OPERATIONS } operation;
static const char *const names[OPERATIONS] = {"add", "sub",        "mul", "square",
                                              "sum", "difference", "div", "sqrt"};

static inline void exactly(int inexact)
{
    if (inexact != 0)
        ck_abort_msg("WIDE is not wide enough");
}

/* Sums and differences of doubles are exact for dd. */
static number apply(number_context *context, operation what, number x, number y)
{
    switch (what) {
    case ADD: return number_add(context, x, y);
    case SUB: return number_sub(context, x, y);
    case MUL: return number_mul(context, x, y);
    case SQUARE: return number_square(context, x);
    case SUM: return number_difference_of(context, LEADING(x), -LEADING(y));
    case DIFFERENCE: return number_difference_of(context, LEADING(x), LEADING(y));
    case DIV: return NUMBER_JOIN(NUMBER, div)(context, x, y);
    default: return NUMBER_JOIN(NUMBER, sqrt)(context, x);
    }
}

/* Called where the compiler can't look, so that the environment can be changed around it. */
static number (*volatile operate)(number_context *, operation, number, number) = apply;

/* Subnormals, results and operands, count as zero; where the processor can. */
static number operate_flushed(number_context *context, operation what, number x, number y)
{
    surroundings_set(SURROUNDINGS_MODES);
    number z = operate(context, what, x, y);
    surroundings_set(0);
    return z;
}

/* Quotients and roots alone are rounded. */
static inline void true_operation(operation what, mpfr_t result, mpfr_t x, mpfr_t y)
{
    switch (what) {
    case ADD:
    case SUM: exactly(mpfr_add(result, x, y, MPFR_RNDN)); break;
    case SUB:
    case DIFFERENCE: exactly(mpfr_sub(result, x, y, MPFR_RNDN)); break;
    case MUL: exactly(mpfr_mul(result, x, y, MPFR_RNDN)); break;
    case SQUARE: exactly(mpfr_sqr(result, x, MPFR_RNDN)); break;
    case DIV: mpfr_div(result, x, y, MPFR_RNDN); break;
    default: mpfr_sqrt(result, x, MPFR_RNDN); break;
    }
}

/* A significand in [1, 2) that is random, or next to a power of two, where bounds are attained. */
static inline double significand(uint64_t bits)
{
    uint64_t kept = bits >> 62 == 0 ? (bits & 0xf) : bits >> 62 == 1 ? ~(bits & 0xf) : bits;
    return double_of(bits_of(1) | (kept & BITS_FRACTION));
}

/* Where they cancel but for a few bits. */
static inline double cancelling(operation what, double x, uint64_t bits)
{
    double near_by = double_of(bits_of(x) ^ (bits & 3));
    return what == SUB || what == DIFFERENCE ? near_by : -near_by;
}
