/* SPDX-License-Identifier: MIT */
/* Of a t^2 + 2 b t + c with b^2 - a c = D the roots are (-b -+ sqrt(D)) / a, so what is linear in
 * one is (e -+ beta sqrt(D)) / a, where e = alpha a - beta b is exact. Where the two cancel,
 *
 *     e -+ beta sqrt(D) = (e^2 - beta^2 D) / (e +- beta sqrt(D)). */
#include "guess.h"

#include <assert.h>

#define NUMBER exact

/* Of a sum that has so many bits less than its terms too few are left. */
#define FEW_BITS 2

/* e + f, where f = -+ beta sqrt(D). */
static wide guess_sum(number_context *c, exact e, wide f, exact beta, exact discriminant)
{
    wide rational = wide_of(e), sum = wide_add(rational, f);
    if (!wide_is_less(sum, rational, FEW_BITS))
        return sum;
    exact norm =
        exact_sub(c, number_square(c, e), exact_mul(c, number_square(c, beta), discriminant));
    return wide_div(wide_of(norm), wide_add(rational, wide_negate(f)));
}

wide guess_linear(number_context *c, const line_coefficients *l, end_kind at, exact alpha,
                  exact beta)
{
    size_t mark = exact_mark(c);
    exact b = l->b, divisor = l->a, discriminant = exact_mul(c, l->factor, l->quarter);
    wide f = wide_of(exact_of(c, 0));
    if (divisor.sign == 0) { /* 2 b t + c */
        divisor = exact_add(c, b, b);
        b = l->c;
    } else {
        assert(exact_compare(c, number_minor(c, l->b, l->a, l->c, l->b), discriminant) == 0);
        f = wide_mul(wide_of(beta), wide_sqrt(wide_of(discriminant)));
        if ((at == END_LESS) == (l->a.sign > 0))
            f = wide_negate(f);
    }
    exact e = number_minor(c, alpha, beta, b, divisor); /* alpha divisor - beta b */
    wide guess = wide_div(guess_sum(c, e, f, beta, discriminant), wide_of(divisor));
    exact_release(c, mark);
    return guess;
}
