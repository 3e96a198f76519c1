/* SPDX-License-Identifier: MIT */
#include "wide.h"

#include "../../numbers/mod128.h"

#include <assert.h>

/* Off by so much or more says nothing of a number, and whatever comes of it is off so, too. */
#define OFF_UNKNOWN (UINT64_C(1) << 31)

static const wide zero = {0, 0, 0, 0}, unknown = {0, OFF_UNKNOWN, 0, 0};

static bool is_zero(wide x)
{
    return x.digits == 0 && x.off == 0;
}

static wide made(int sign, uint64_t digits, uint64_t off, int exponent)
{
    int unused = digits == 0 ? 0 : 64 - bits_in(digits);
    bool known = unused < 31 && off < OFF_UNKNOWN >> unused;
    return (wide){digits << unused, known ? off << unused : OFF_UNKNOWN, exponent - unused,
                  digits == 0 ? 0 : sign};
}

wide wide_of(exact x)
{
    int exponent;
    if (x.sign == 0)
        return zero;
    uint64_t top = exact_top(x, &exponent);
    return (wide){top, 1, exponent, x.sign};
}

/* What is less than a unit of x is cut off y. */
wide wide_add(wide x, wide y)
{
    if (x.digits == 0 || (y.digits != 0 && x.exponent < y.exponent)) {
        wide less = x;
        x = y;
        y = less;
    }
    if (is_zero(y))
        return x;
    int apart = x.exponent - y.exponent;
    if (apart < 0 || x.off >= OFF_UNKNOWN || y.off >= OFF_UNKNOWN)
        return unknown;
    uint64_t digits = apart < 64 ? y.digits >> apart : 0;
    uint64_t off = x.off + (apart < 32 ? y.off >> apart : 0) + 2;
    if (x.sign != y.sign && digits > x.digits)
        return made(y.sign, digits - x.digits, off, x.exponent);
    if (x.sign != y.sign)
        return made(x.sign, x.digits - digits, off, x.exponent);
    uint64_t sum = x.digits + digits;
    if (sum >= digits)
        return made(x.sign, sum, off, x.exponent);
    return made(x.sign, sum >> 1 | UINT64_C(1) << 63, off / 2 + 1, x.exponent + 1);
}

wide wide_mul(wide x, wide y)
{
    uint128 product = uint128_mul(UINT128(0, x.digits), UINT128(0, y.digits));
    if (is_zero(x) || is_zero(y))
        return zero;
    return made(x.sign * y.sign, UINT128_HIGH(product), x.off + y.off + 2,
                x.exponent + y.exponent + 64);
}

/* The next 32 bits of rest / y as on paper, by y's upper half: too many by 2 at most. rest < y, the
 * first bit of y is 1. */
static uint64_t next_digits(uint64_t *rest, uint64_t y)
{
    uint64_t upper = y >> 32, lower = (uint32_t)y, digits = *rest / upper;
    uint64_t left = *rest - digits * upper;
    while (left <= UINT32_MAX && digits * lower > left << 32) {
        digits--;
        left += upper;
    }
    *rest = (left << 32) - digits * lower;
    return digits;
}

wide wide_div(wide x, wide y)
{
    if (y.digits == 0)
        return unknown;
    if (is_zero(x))
        return zero;
    bool first = x.digits >= y.digits;
    uint64_t rest = first ? x.digits - y.digits : x.digits, upper = next_digits(&rest, y.digits);
    uint64_t quotient = (upper << 32 | next_digits(&rest, y.digits)) >> 1 | (uint64_t)first << 63;
    return made(x.sign * y.sign, quotient, x.off + 2 * y.off + 3, x.exponent - y.exponent - 63);
}

/* The root of digits * 2^64, or of half that, whatever leaves an even exponent: its upper half bit
 * by bit, and by that the lower one, too great by 1 at most (P. Zimmermann, Karatsuba square root,
 * INRIA RR-3805, 1999). */
wide wide_sqrt(wide x)
{
    int odd = x.exponent & 1; /* also where the exponent is negative */
    uint64_t high = x.digits >> odd, low = odd ? x.digits << 63 : 0, upper = 0;
    assert(x.sign >= 0);
    if (x.digits == 0)
        return is_zero(x) ? zero : unknown;
    for (uint64_t bit = UINT64_C(1) << 31; bit != 0; bit >>= 1)
        upper |= (upper | bit) * (upper | bit) <= high ? bit : 0;
    uint64_t lower = ((high - upper * upper) << 31 | low >> 33) / upper;
    uint64_t root = upper << 32 | (lower > UINT32_MAX ? UINT32_MAX : lower);
    uint128 square = uint128_mul(UINT128(0, root), UINT128(0, root));
    uint64_t above = UINT128_HIGH(square);
    root -= above > high || (above == high && UINT128_LOW(square) > low);
    return made(x.sign, root, x.off + 1, (x.exponent + odd - 64) / 2);
}

bool wide_rounds(const exact_context *c, wide x, double *rounded)
{
    *rounded = 0;
    if (x.digits == 0)
        return is_zero(x);
    bool one = exact_rounds(c, x.sign, x.digits, x.off, x.exponent, rounded);
    return one && x.off < OFF_UNKNOWN;
}
