#include "exact.h"

#include "bits.h"

#include <stdlib.h>

#ifdef __GNUC__
#define OUT_OF_LINE __attribute__((noinline))
#else
#define OUT_OF_LINE
#endif

static const exact zero = {NULL, 0, 0, 0};

/* Room at the arena's end; finish() takes as much of it as is needed. */
static mp_limb_t *room_for(const exact_context *c, int count)
{
    if (count > INT16_MAX || c->capacity - c->used < (size_t)count)
        abort(); /* never: users count what they need */
    return c->limbs + c->used;
}

/* The number in room_for(c, size), trimmed. What is trimmed stays used: the next number's place
 * need not wait for this one's limbs. */
static exact finish(exact_context *c, mp_limb_t *limbs, int size, int sign, int exponent)
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

/* sign * mantissa * 2^exponent */
static exact placed(exact_context *c, int sign, uint64_t mantissa, int exponent)
{
    int shift = exponent & 63; /* exponent = 64 limb + shift, also where it is negative */
    int limb = (exponent - shift) / 64;
    mp_limb_t *limbs = room_for(c, 2);
    limbs[0] = (mp_limb_t)mantissa << shift;
    limbs[1] = shift == 0 ? 0 : (mp_limb_t)mantissa >> (64 - shift);
    return finish(c, limbs, 2, sign, limb);
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
static mp_limb_t limb_of(exact x, int at)
{
    bool within = (unsigned)at < (unsigned)x.size;
    return x.limbs[within ? at : 0] & -(mp_limb_t)within;
}

/* x + y, neither of them 0. No processor foresees signs, so few are branched on: a difference is
 * x + (2^(64 size) - y), for which y's limbs are flipped and the carry starts at 1; without a carry
 * out it is negative, and negated. */
static exact sum(exact_context *c, exact x, exact y)
{
    int low = x.exponent < y.exponent ? x.exponent : y.exponent;
    int x_end = x.exponent + x.size, y_end = y.exponent + y.size;
    int size = (x_end > y_end ? x_end : y_end) - low;
    int x_from = x.exponent - low, y_from = y.exponent - low;
    mp_limb_t *r = room_for(c, size + 1);
    mp_limb_t flip = -(mp_limb_t)(x.sign != y.sign), carry = flip & 1;
    for (int i = 0; i < size; i++) {
        mp_limb_t partial = limb_of(x, i - x_from) + carry;
        mp_limb_t addend = limb_of(y, i - y_from) ^ flip;
        r[i] = partial + addend;
        carry = (mp_limb_t)(partial < carry) + (mp_limb_t)(r[i] < addend);
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
    mp_limb_t *r = room_for(c, size);
    if (x.limbs == y.limbs && x.size == y.size)
        mpn_sqr(r, x.limbs, x.size);
    else if (x.size >= y.size)
        mpn_mul(r, x.limbs, x.size, y.limbs, y.size);
    else
        mpn_mul(r, y.limbs, y.size, x.limbs, x.size);
    return finish(c, r, size, x.sign * y.sign, x.exponent + y.exponent);
}

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 two_limbs;

/* Both of one or two limbs, and taken as two: in r are 4, those above x.size + y.size 0. */
static exact short_product(exact_context *c, exact x, exact y)
{
    mp_limb_t *r = room_for(c, 4);
    mp_limb_t x0 = x.limbs[0], x1 = limb_of(x, 1), y0 = y.limbs[0], y1 = limb_of(y, 1);
    two_limbs low = (two_limbs)x0 * y0;
    two_limbs middle = (two_limbs)x1 * y0 + (mp_limb_t)(low >> 64);
    two_limbs other = (two_limbs)x0 * y1 + (mp_limb_t)middle;
    two_limbs high = (two_limbs)x1 * y1 + (mp_limb_t)(middle >> 64) + (mp_limb_t)(other >> 64);
    r[0] = (mp_limb_t)low;
    r[1] = (mp_limb_t)other;
    r[2] = (mp_limb_t)high;
    r[3] = (mp_limb_t)(high >> 64);
    return finish(c, r, x.size + y.size, x.sign * y.sign, x.exponent + y.exponent);
}
#endif

exact exact_mul(exact_context *c, exact x, exact y)
{
    if (x.sign == 0 || y.sign == 0)
        return zero;
#ifdef __SIZEOF_INT128__
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
    int order = mpn_cmp(x.limbs + (x.size - common), y.limbs + (y.size - common), common);
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

/* Bits of the integer in limbs of which the last is not 0. */
static int width(const mp_limb_t *limbs, int size)
{
    return (int)mpn_sizeinbase(limbs, size, 2);
}

uint64_t exact_top(exact x, int *exponent)
{
    mp_limb_t top = x.limbs[x.size - 1], next = x.size > 1 ? x.limbs[x.size - 2] : 0;
    int unused = 64 - width(&top, 1);
    *exponent = 64 * (x.exponent + x.size - 1) - unused;
    return unused == 0 ? top : top << unused | next >> (64 - unused);
}

/* The double nearest to (q + a fraction if `more`) * 2^exponent, q of 63 or 64 bits. */
static double rounded(int sign, mp_limb_t q, bool more, int exponent)
{
    int bits = width(&q, 1);
    int leading = exponent + bits - 1; /* 2^leading <= value < 2^(leading + 1) */
    bool normal = leading >= -1022;
    if (leading < -1075)
        return 0;
    int kept = normal ? 53 : leading + 1075, dropped = bits - kept;
    uint64_t result = BITS_INFINITY;
    if (leading <= 1023) {
        uint64_t mantissa = dropped == 64 ? 0 : q >> dropped;
        uint64_t half = UINT64_C(1) << (dropped - 1), rest = q & (half - 1 + half);
        if (rest > half || (rest == half && (more || (mantissa & 1) != 0)))
            mantissa++;
        /* The mantissa's leading bit, and a carry out of it, count in the exponent. */
        result = ((uint64_t)(normal ? leading + 1022 : 0) << 52) + mantissa;
    }
    if (sign < 0 && result != 0)
        result |= BITS_SIGN;
    return double_of(result);
}

/* The limbs of x * 2^shift. */
static exact shifted(exact_context *c, exact x, int shift)
{
    int whole = shift / 64, size = x.size + whole + 1;
    mp_limb_t *r = room_for(c, size);
    mpn_zero(r, whole);
    mpn_copyi(r + whole, x.limbs, x.size);
    r[size - 1] =
        shift % 64 == 0 ? 0 : mpn_lshift(r + whole, r + whole, x.size, (unsigned)(shift % 64));
    while (r[size - 1] == 0)
        size--;
    c->used += (size_t)size;
    return (exact){r, x.exponent, (int16_t)size, x.sign};
}

double exact_quotient(exact_context *c, exact n, exact d)
{
    if (n.sign == 0)
        return 0;
    size_t mark = exact_mark(c);
    /* Shifted so that the integers' quotient has 63 or 64 bits. */
    int shift = 63 - (width(n.limbs, n.size) - width(d.limbs, d.size));
    exact top = shift > 0 ? shifted(c, n, shift) : n;
    exact bottom = shift < 0 ? shifted(c, d, -shift) : d;
    int count = top.size - bottom.size + 1;
    mp_limb_t *quotient = room_for(c, count + bottom.size), *rest = quotient + count;
    mpn_tdiv_qr(quotient, rest, 0, top.limbs, top.size, bottom.limbs, bottom.size);
    bool more = !mpn_zero_p(rest, bottom.size);
    exact_release(c, mark);
    return rounded(n.sign * d.sign, quotient[0], more, 64 * (n.exponent - d.exponent) - shift);
}
