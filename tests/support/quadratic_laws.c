/* SPDX-License-Identifier: MIT */
#include "quadratic_laws.h"

#include "tiers.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#endif

#include <float.h>
#include <string.h>

#include <surehit/bounds.h>
#include <surehit/quadratic.h>

static sure_roots (*const solve[TIERS])(double, double, double,
                                        double *) = OF_TIERS(sure_quadratic);

typedef struct {
    sure_roots count;
    double roots[2];
} solution;

/* Numbers of the tier. */

static polynomial rounded_all(sure_tier tier, polynomial p)
{
    return (polynomial){rounded(tier, p.a), rounded(tier, p.h), rounded(tier, p.c)};
}

bool is_finite(polynomial p)
{
    return isfinite(p.a) && isfinite(p.h) && isfinite(p.c);
}

/* Answers. */

static solution untouched(void)
{
    solution s;
    memset(&s, 0xa5, sizeof s);
    return s;
}

static solution ask(polynomial p, sure_tier tier)
{
    solution s = untouched();
    s.count = solve[tier](p.a, p.h, p.c, s.roots);
    return s;
}

static int written(const solution *s)
{
    return s->count == SURE_ROOTS_TWO ? 2 : s->count == SURE_ROOTS_ONE ? 1 : 0;
}

static void check_outcome(polynomial p, sure_tier tier, const solution *s)
{
    const solution before = untouched();
    const int count = written(s);
    expect(s->count <= SURE_ROOTS_ALL, "a count that is none");
    expect(memcmp(s->roots + count, before.roots + count, sizeof(double) * (size_t)(2 - count)) ==
               0,
           "a root that there is not is written");
    if (s->count == SURE_ROOTS_TWO && is_finite(rounded_all(tier, p)))
        expect(s->roots[0] <= s->roots[1], "roots out of order");
}

/* The roots of two polynomials agree, the second's read backwards and negated if `mirrored`. */
static bool agree(const solution *s, const solution *other, bool mirrored)
{
    if (s->count != other->count)
        return false;
    if (s->count == SURE_ROOTS_ONE)
        return same(s->roots[0], mirrored ? -other->roots[0] : other->roots[0]);
    if (s->count != SURE_ROOTS_TWO)
        return true;
    if (mirrored)
        return same(s->roots[0], -other->roots[1]) && same(s->roots[1], -other->roots[0]);
    return same(s->roots[0], other->roots[0]) && same(s->roots[1], other->roots[1]);
}

static void check_law_2(polynomial p, sure_tier tier, const solution *s)
{
    solution negated = ask((polynomial){-p.a, -p.h, -p.c}, tier);
    solution mirrored = ask((polynomial){p.a, -p.h, p.c}, tier);
    expect(agree(s, &negated, false), "Law 2: the signs of all change the roots");
    expect(agree(s, &mirrored, true), "Law 2: the sign of half_b does not mirror them");
}

/* Can nothing over- or underflow on the way to the roots? The products of two such numbers and the
 * sums of those are normal, or 0. */
static bool is_moderate(sure_tier tier, double x)
{
    double least = tier == SURE_TIER_FLOAT32 ? 0x1p-30 : 0x1p-250;
    double most = tier == SURE_TIER_FLOAT32 ? 0x1p60 : 0x1p500;
    return x == 0 || (fabs(x) >= least && fabs(x) <= most);
}

static bool all_moderate(sure_tier tier, polynomial p)
{
    return is_moderate(tier, p.a) && is_moderate(tier, p.h) && is_moderate(tier, p.c);
}

static bool all_roots_normal(const solution *s)
{
    for (int i = 0; i < written(s); i++) {
        if (s->roots[i] != 0 && !isnormal(s->roots[i]))
            return false;
    }
    return true;
}

static polynomial times_power(polynomial p, int k)
{
    return (polynomial){ldexp(p.a, k), ldexp(p.h, k), ldexp(p.c, k)};
}

/* Stable takes powers of two out of its own accord: the ends alone have to be in range. */
static bool law_3_applies(polynomial p, polynomial scaled, sure_tier tier, const solution *s, int k)
{
    polynomial back = times_power(scaled, -k);
    if (tier == SURE_TIER_STABLE)
        return is_finite(scaled) && back.a == p.a && back.h == p.h && back.c == p.c &&
               all_roots_normal(s);
    return all_moderate(tier, p) && all_moderate(tier, scaled);
}

static void check_law_3(polynomial given, sure_tier tier, const solution *s, int k)
{
    polynomial p = rounded_all(tier, given), scaled = times_power(p, k);
    if (!law_3_applies(p, scaled, tier, s, k))
        return;
    solution other = ask(scaled, tier);
    expect(agree(s, &other, false), "Law 3: a power of two changes the roots");
}

#ifndef FUZZ_WITHOUT_REFERENCE
/* The step to the next number of greater magnitude, as bounds.h has it. */
static long double ulp(sure_tier tier, double x)
{
    int exponent;
    (void)frexp(x, &exponent);
    int place = tier == SURE_TIER_FLOAT32 ? exponent - 24 : exponent - 53;
    int least = tier == SURE_TIER_FLOAT32 ? -149 : -1074;
    return ldexpl(1, x == 0 || place < least ? least : place);
}

/* Is it a number of the tier? */
static bool is_of(sure_tier tier, double x)
{
    return isfinite(x) && rounded(tier, x) == x;
}

/* Is the product a number of the tier? What a double's rounding loses is seen by fma. */
static bool exact_product(sure_tier tier, double x, double y, double *product)
{
    *product = x * y;
    if (x == 0 || y == 0)
        return true;
    if (tier == SURE_TIER_FLOAT32) /* a double holds it */
        return is_of(tier, *product);
    return fabs(*product) >= 0x1p-900 && isfinite(*product) && fma(x, y, -*product) == 0;
}

static bool exact_difference(sure_tier tier, double x, double y, double *difference)
{
    double d = x - y, from_x = x - d;
    *difference = d;
    return is_of(tier, d) && from_x == y && x - from_x == d;
}

/* D/4, where no step to it is rounded. */
static bool exact_quarter(sure_tier tier, polynomial p, double *quarter)
{
    double hh, ac;
    return exact_product(tier, p.h, p.h, &hh) && exact_product(tier, p.a, p.c, &ac) &&
           exact_difference(tier, hh, ac, quarter);
}

/* Each root is off by SURE_ROOT_ULPS of the larger; the reference's, which is rounded, by half of
 * its own last place. */
static void check_bound(sure_tier tier, const solution *s, const solution *truth)
{
    double larger = fmax(fabs(truth->roots[0]), fabs(truth->roots[1]));
    if (!isfinite(rounded(tier, larger)))
        return;
    for (int i = 0; i < 2; i++) {
        long double off = fabsl((long double)s->roots[i] - truth->roots[i]);
        long double most =
            SURE_ROOT_ULPS * ulp(tier, larger) + ulp(SURE_TIER_TEXTBOOK, truth->roots[i]) / 2;
        expect(off <= most, "a root beyond SURE_ROOT_ULPS");
    }
}

static bool is_whole(double x)
{
    return fabs(x) <= 0x1p53 && nearbyint(x) == x;
}

/* Law 1's second half: whole numbers whose D/4 is a square, with sums that are not rounded. */
static bool is_whole_square(sure_tier tier, polynomial p, double quarter)
{
    double root = sqrt(quarter);
    return is_whole(p.a) && is_whole(p.h) && is_whole(p.c) && is_whole(root) &&
           fabs(p.h) + root <= (tier == SURE_TIER_FLOAT32 ? 0x1p24 : 0x1p53) && root <= 0x1p26 &&
           root * root == quarter;
}

static void check_quotients(polynomial p, sure_tier tier, const solution *s, double root)
{
    double less = rounded(tier, (-p.h - root) / p.a), more = rounded(tier, (-p.h + root) / p.a);
    expect(s->roots[0] == fmin(less, more) && s->roots[1] == fmax(less, more),
           "Law 1: a root that is not the rounded quotient");
}

static void check_law_1(polynomial p, sure_tier tier, const solution *s, const solution *truth)
{
    double quarter;
    if (!exact_quarter(tier, p, &quarter))
        return;
    expect(s->count == truth->count, "Law 1: a wrong count, D/4 being exact");
    if (s->count != SURE_ROOTS_TWO)
        return;
    check_bound(tier, s, truth);
    if (is_whole_square(tier, p, quarter))
        check_quotients(p, tier, s, sqrt(quarter));
}

/* Without a square there is one division to round. */
static void check_linear(sure_tier tier, const solution *s, const solution *truth)
{
    double right = rounded(tier, truth->roots[0]);
    double least = tier == SURE_TIER_FLOAT32 ? FLT_MIN : DBL_MIN;
    double most = tier == SURE_TIER_FLOAT32 ? FLT_MAX / 2 : DBL_MAX / 2;
    expect(s->count == truth->count, "a wrong count, a being 0");
    if (s->count == SURE_ROOTS_ONE && fabs(right) >= least && fabs(right) <= most)
        expect(s->roots[0] == right, "the linear root is not the rounded quotient");
}

/* The truth is off by half a step. Below the power of two that is next to it steps are half as
 * long. */
static bool within_stable_bound(double x, double right)
{
    int exponent, right_exponent;
    (void)frexp(x, &exponent);
    (void)frexp(right, &right_exponent);
    bool shorter = fabs(x) < fabs(right) && (exponent < right_exponent || isinf(right));
    uint64_t most = shorter ? 2 * SURE_STABLE_ROOT_ULPS + 1 : SURE_STABLE_ROOT_ULPS;
    return reference_ulps(x, right) <= most;
}

static void check_stable(const solution *s, const solution *truth)
{
    expect(s->count == truth->count, "a wrong count");
    for (int i = 0; i < written(s); i++)
        expect(within_stable_bound(s->roots[i], truth->roots[i]),
               "a root beyond SURE_STABLE_ROOT_ULPS");
}

static void check_reference(polynomial given, sure_tier tier, const solution *s)
{
    polynomial p = rounded_all(tier, given);
    solution truth = untouched();
    if (!is_finite(p))
        return;
    truth.count = reference_quadratic(p.a, p.h, p.c, truth.roots);
    if (p.a == 0)
        check_linear(tier, s, &truth);
    else
        check_law_1(p, tier, s, &truth);
    if (tier == SURE_TIER_STABLE)
        check_stable(s, &truth);
}
#endif

void quadratic_check(polynomial p, sure_tier tier, int k)
{
    solution s = ask(p, tier);
    check_outcome(p, tier, &s);
    check_law_2(p, tier, &s);
    check_law_3(p, tier, &s, k);
#ifndef FUZZ_WITHOUT_REFERENCE
    check_reference(p, tier, &s);
#endif
}
