/* SPDX-License-Identifier: MIT */
#include "exact.h"

#include "bits.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#ifdef __GNUC__
#define OUT_OF_LINE __attribute__((noinline))
#else
#define OUT_OF_LINE
#endif

/* Twice a limb's bits. */
#if EXACT_LIMB_BITS == 32
typedef uint64_t exact_limb_pair;
#elif defined __SIZEOF_INT128__
__extension__ typedef unsigned __int128 exact_limb_pair;
#else
#define ONLY_LONG_PRODUCTS
#endif

/* GMP's function, or our own of the name. */
#ifdef SURE_GMP
#define LIMBS(function) mpn_##function
#else
#define LIMBS(function) limbs_##function##_exact_limb
#define NUMBER exact_limb
#include "digits/limbs_tmpl.h"
#endif

/* As bits.h refuses what else is told; of this (-fsingle-precision-constant) C alone tells. */
_Static_assert(sizeof 1.0 == sizeof(double), "surehit needs constants of doubles");

static const exact zero = {NULL, 0, 0, 0};

/* Room at the arena's end; finish() takes as much of it as is needed. */
static exact_limb *room_for(const exact_context *c, int count)
{
    if (count > INT16_MAX || c->capacity - c->used < (size_t)count)
        abort(); /* never: users count what they need */
    return c->limbs + c->used;
}

/* The number in room_for(c, size), trimmed. What is trimmed stays used: the next number's place
 * need not wait for this one's limbs. */
static exact finish(exact_context *c, exact_limb *limbs, int size, int sign, int exponent)
{
    c->used += (size_t)size;
    size -= limbs[size - 1] == 0; /* as likely as not: no branch */
    while (size > 0 && limbs[size - 1] == 0)
        size--;
    if (size == 0)
        return zero;
    while (*limbs == 0) {
        limbs++;
        size--;
        exponent++;
    }
    return (exact){limbs, exponent, (int16_t)size, (int16_t)sign};
}

enum { LIMBS_OF_64 = 64 / EXACT_LIMB_BITS };

/* sign * mantissa * 2^exponent */
static exact placed(exact_context *c, int sign, uint64_t mantissa, int exponent)
{
    int shift = exponent & (EXACT_LIMB_BITS - 1); /* also where the exponent is negative */
    int first = (exponent - shift) / EXACT_LIMB_BITS;
    exact_limb *limbs = room_for(c, LIMBS_OF_64 + 1), out = 0;
    for (int i = 0; i < LIMBS_OF_64; i++) {
        exact_limb part = (exact_limb)(mantissa >> (EXACT_LIMB_BITS * i));
        limbs[i] = part << shift | out;
        out = shift == 0 ? 0 : part >> (EXACT_LIMB_BITS - shift);
    }
    limbs[LIMBS_OF_64] = out;
    return finish(c, limbs, LIMBS_OF_64 + 1, sign, first);
}

exact exact_of(exact_context *c, double x)
{
    magnitude_parts parts = parts_of(x);
    return placed(c, is_negative_bits(x) ? -1 : 1, parts.mantissa, parts.exponent);
}

exact exact_scaled(exact_context *c, int64_t mantissa, int exponent)
{
    uint64_t magnitude = mantissa < 0 ? -(uint64_t)mantissa : (uint64_t)mantissa;
    return placed(c, mantissa < 0 ? -1 : 1, magnitude, exponent);
}

/* Limb `at` of x, which has none outside its size. Without branches: nobody foresees which. */
static exact_limb limb_of(exact x, int at)
{
    bool within = (unsigned)at < (unsigned)x.size;
    return x.limbs[within ? at : 0] & -(exact_limb)within;
}

/* x + y, neither of them 0. No processor foresees signs, so few are branched on: a difference is
 * x + (B^size - y), B = 2^EXACT_LIMB_BITS, for which y's limbs are flipped and the carry starts at
 * 1; without a carry out it is negative, and negated. */
static exact sum(exact_context *c, exact x, exact y)
{
    int low = x.exponent < y.exponent ? x.exponent : y.exponent;
    int x_end = x.exponent + x.size, y_end = y.exponent + y.size;
    int size = (x_end > y_end ? x_end : y_end) - low;
    int x_from = x.exponent - low, y_from = y.exponent - low;
    exact_limb *r = room_for(c, size + 1);
    exact_limb flip = -(exact_limb)(x.sign != y.sign), carry = flip & 1;
    for (int i = 0; i < size; i++) {
        exact_limb partial = limb_of(x, i - x_from) + carry;
        exact_limb addend = limb_of(y, i - y_from) ^ flip;
        r[i] = partial + addend;
        carry = (exact_limb)(partial < carry) + (exact_limb)(r[i] < addend);
    }
    r[size] = carry & ~flip;
    int sign = x.sign;
    if ((flip & (carry - 1)) != 0) {
        sign = y.sign;
        carry = 1;
        for (int i = 0; i < size; i++) {
            r[i] = ~r[i] + carry;
            carry = r[i] < carry;
        }
    }
    return finish(c, r, size + 1, sign, low);
}

exact exact_add(exact_context *c, exact x, exact y)
{
    if (x.sign == 0)
        return y;
    return y.sign == 0 ? x : sum(c, x, y);
}

/* Kept out of the way of short numbers, whose code would have to save registers for it. */
static OUT_OF_LINE exact long_product(exact_context *c, exact x, exact y)
{
    int size = x.size + y.size;
    exact_limb *r = room_for(c, size);
    if (x.limbs == y.limbs && x.size == y.size)
        LIMBS(sqr)(r, x.limbs, x.size);
    else if (x.size >= y.size)
        LIMBS(mul)(r, x.limbs, x.size, y.limbs, y.size);
    else
        LIMBS(mul)(r, y.limbs, y.size, x.limbs, x.size);
    return finish(c, r, size, x.sign * y.sign, x.exponent + y.exponent);
}

#ifndef ONLY_LONG_PRODUCTS
/* Both of one or two limbs, and taken as two: in r are 4, those above x.size + y.size 0. */
static exact short_product(exact_context *c, exact x, exact y)
{
    exact_limb *r = room_for(c, 4);
    exact_limb x0 = x.limbs[0], x1 = limb_of(x, 1), y0 = y.limbs[0], y1 = limb_of(y, 1);
    exact_limb_pair low = (exact_limb_pair)x0 * y0;
    exact_limb_pair middle = (exact_limb_pair)x1 * y0 + (exact_limb)(low >> EXACT_LIMB_BITS);
    exact_limb_pair other = (exact_limb_pair)x0 * y1 + (exact_limb)middle;
    exact_limb_pair high = (exact_limb_pair)x1 * y1 + (exact_limb)(middle >> EXACT_LIMB_BITS) +
                           (exact_limb)(other >> EXACT_LIMB_BITS);
    r[0] = (exact_limb)low;
    r[1] = (exact_limb)other;
    r[2] = (exact_limb)high;
    r[3] = (exact_limb)(high >> EXACT_LIMB_BITS);
    return finish(c, r, x.size + y.size, x.sign * y.sign, x.exponent + y.exponent);
}
#endif

exact exact_mul(exact_context *c, exact x, exact y)
{
    if (x.sign == 0 || y.sign == 0)
        return zero;
#ifndef ONLY_LONG_PRODUCTS
    if (x.size <= 2 && y.size <= 2)
        return short_product(c, x, y);
#endif
    return long_product(c, x, y);
}

/* Sign of |x| - |y|, neither of them 0. */
static int compare_magnitudes(exact x, exact y)
{
    int x_end = x.exponent + x.size, y_end = y.exponent + y.size;
    if (x_end != y_end)
        return x_end > y_end ? 1 : -1;
    int common = x.size < y.size ? x.size : y.size;
    int order = LIMBS(cmp)(x.limbs + (x.size - common), y.limbs + (y.size - common), common);
    if (order != 0)
        return order > 0 ? 1 : -1;
    return (x.size > y.size) - (x.size < y.size); /* what is left below is not 0 */
}

int exact_compare(exact_context *c, exact x, exact y)
{
    (void)c;
    if (x.sign != y.sign)
        return x.sign > y.sign ? 1 : -1;
    return x.sign == 0 ? 0 : x.sign * compare_magnitudes(x, y);
}

/* Bits of the integer of x. */
static int width(exact x)
{
    return EXACT_LIMB_BITS * (x.size - 1) + bits_in(x.limbs[x.size - 1]);
}

/* 64 bits of x's limbs, from limb `at` on. */
static uint64_t word_of(exact x, int at)
{
    uint64_t word = 0;
    for (int i = 0; i < LIMBS_OF_64; i++)
        word |= (uint64_t)limb_of(x, at + i) << (EXACT_LIMB_BITS * i);
    return word;
}

uint64_t exact_top(exact x, int *exponent)
{
    int at = x.size - LIMBS_OF_64;
    uint64_t top = word_of(x, at), next = limb_of(x, at - 1);
    int unused = 64 - bits_in(top);
    *exponent = EXACT_LIMB_BITS * (x.exponent + at) - unused;
    return unused == 0 ? top : top << unused | next >> (EXACT_LIMB_BITS - unused);
}

/* The double nearest to (q + a fraction if `more`) * 2^exponent, q of 63 or 64 bits; or to odd. */
static double rounded(const exact_context *c, int sign, uint64_t q, bool more, int exponent)
{
    int bits = bits_in(q);
    int leading = exponent + bits - 1; /* 2^leading <= value < 2^(leading + 1) */
    bool normal = leading >= -1022;
    int kept = normal ? 53 : leading + 1075, dropped = bits - kept;
    uint64_t result = leading < -1075 ? c->to_odd : BITS_INFINITY;
    if (leading >= -1075 && leading <= 1023) {
        uint64_t mantissa = dropped == 64 ? 0 : q >> dropped;
        uint64_t half = UINT64_C(1) << (dropped - 1), rest = q & (half - 1 + half);
        if (c->to_odd)
            mantissa |= rest != 0 || more;
        else if (rest > half || (rest == half && (more || (mantissa & 1) != 0)))
            mantissa++;
        /* The mantissa's leading bit, and a carry out of it, count in the exponent. */
        result = ((uint64_t)(normal ? leading + 1022 : 0) << 52) + mantissa;
    }
    if (sign < 0 && result != 0)
        result |= BITS_SIGN;
    return double_of(result);
}

bool exact_rounds(const exact_context *c, int sign, uint64_t digits, uint64_t off, int exponent,
                  double *rounded_to)
{
    assert(digits >> 62 != 0 && off >> 32 == 0);
    bool fits = digits + off >= digits;
    *rounded_to = rounded(c, sign, digits - off, false, exponent);
    double high = rounded(c, sign, fits ? digits + off : digits, false, exponent);
    return fits && bits_of(*rounded_to) == bits_of(high);
}

/* The limbs of x * 2^shift. */
static exact shifted(exact_context *c, exact x, int shift)
{
    int whole = shift / EXACT_LIMB_BITS, part = shift % EXACT_LIMB_BITS, size = x.size + whole + 1;
    exact_limb *r = room_for(c, size), *moved = r + whole;
    memset(r, 0, (size_t)whole * sizeof *r);
    memcpy(moved, x.limbs, (size_t)x.size * sizeof *r);
    r[size - 1] = part == 0 ? 0 : LIMBS(lshift)(moved, moved, x.size, (unsigned)part);
    while (r[size - 1] == 0)
        size--;
    c->used += (size_t)size;
    return (exact){r, x.exponent, (int16_t)size, x.sign};
}

/* Are all limbs 0? */
static bool are_zero(const exact_limb *limbs, int size)
{
    while (size > 0 && limbs[size - 1] == 0)
        size--;
    return size == 0;
}

double exact_quotient(exact_context *c, exact n, exact d)
{
    if (n.sign == 0 || d.sign == 0)
        return 0;
    size_t mark = exact_mark(c);
    /* Shifted so that the integers' quotient has 63 or 64 bits, and the divisor's first bit leads
     * its limb. */
    int shift = 63 - width(n) + width(d), up = -width(d) & (EXACT_LIMB_BITS - 1);
    while (shift + up < 0)
        up += EXACT_LIMB_BITS;
    exact top = shifted(c, n, shift + up), bottom = shifted(c, d, up);
    int count = top.size - bottom.size + 1;
    exact_limb *quotient = room_for(c, count + top.size + 1), *rest = quotient + count;
    LIMBS(tdiv_qr)(quotient, rest, 0, top.limbs, top.size, bottom.limbs, bottom.size);
    uint64_t q = word_of((exact){quotient, 0, (int16_t)count, 1}, 0);
    bool more = !are_zero(rest, bottom.size);
    exact_release(c, mark);
    return rounded(c, n.sign * d.sign, q, more,
                   EXACT_LIMB_BITS * (n.exponent - d.exponent) - shift);
}
