/* SPDX-License-Identifier: MIT */
/* What a first stage computes, step by step. */
#ifndef PROOFS_TAPE_HPP
#define PROOFS_TAPE_HPP

#include "number.hpp"

#include <vector>

struct step {
    operation what;
    int x, y;                   /* which steps it is made of, 0: a constant, */
    double by_x, by_y, rounded; /* derivatives by these, and by its rounding's share */
    double of_x, of_y;          /* what these are */
};
static std::vector<step> tape;
static std::vector<scalar> inverted; /* what 1 was divided by */

struct comparison {
    scalar greater, less;
};
static std::vector<comparison> comparisons; /* in their order: is one greater? */

void compared(scalar greater, scalar less)
{
    comparisons.push_back({greater, less});
}

static bool is_power_of_two(scalar x)
{
    int exponent;
    return x.step == 0 && fabs(frexp(x.value, &exponent)) == 0.5;
}

static scalar put(const step &next, double value)
{
    tape.push_back(next);
    return scalar(value, static_cast<int>(tape.size()) - 1);
}

scalar computed(operation what, scalar x, scalar y, double exact)
{
    if (x.step == 0 && y.step == 0)
        return exact;
    double by_x = 1, by_y = what == DIFFERENCE ? -1 : 1, rounded = exact;
    if (what == PRODUCT) {
        by_x = y.value, by_y = x.value;
        if (is_power_of_two(x) || is_power_of_two(y))
            rounded = 0;
    }
    if (what == QUOTIENT)
        by_x = 1 / y.value, by_y = -exact / y.value;
    if (what == ROOT)
        by_x = 0.5 / exact;
    if (what == NEGATION)
        by_x = -1, rounded = 0;
    if (what == MAGNITUDE || what == SIGNED)
        by_x = signbit(x.value) == signbit(exact) ? 1 : -1, by_y = 0, rounded = 0;
    if (what == QUOTIENT && x.step == 0 && x.value == 1)
        inverted.push_back(y);
    return put({what, x.step, y.step, by_x, by_y, rounded, x.value, y.value}, exact);
}

/* A query whose numbers are the tape's first steps. */
static query recorded(sure_shape shape, const double x[])
{
    scalar inputs[INPUTS];
    tape.assign(1, step());
    inverted.clear();
    comparisons.clear();
    for (int i = 0; i < INPUTS; i++)
        inputs[i] = put({GIVEN, 0, 0, 0, 0, 0, 0, 0}, i == T_MIN ? fabs(x[i]) : x[i]);
    return query_of(shape, inputs);
}

#endif
