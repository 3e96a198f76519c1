/* SPDX-License-Identifier: MIT */
/* Products, quotients, shifts and comparisons of long numbers (limbs_tmpl.h), in limbs of three
 * sizes: against GMP's integers, and in limbs of 8 bits every number that there is, or every one at
 * which a digit changes. */
#include "../support/suite.h"
#include "../support/true_number.h"

#include "../../src/numbers/number.h"

enum { DRAWS = 2000 };

static void integer_clear(mpz_t *x)
{
    mpz_clear(*x);
}

#define INTEGER(unused, x)                                                                         \
    FREED_BY(integer_clear) mpz_t x;                                                               \
    mpz_init(x)
#define INTEGERS(...) TRUE_EACH(INTEGER, 0, __VA_ARGS__)

typedef uint8_t limb8;
typedef uint16_t limb8_pair;
#define NUMBER limb8
#include "../../src/numbers/digits/limbs_tmpl.h"
#define NUMBER limb8
#include "check_limbs_tmpl.h"

typedef uint32_t limb32;
typedef uint64_t limb32_pair;
#define NUMBER limb32
#include "../../src/numbers/digits/limbs_tmpl.h"
#define NUMBER limb32
#include "check_limbs_tmpl.h"

#ifdef __SIZEOF_INT128__
typedef uint64_t limb64;
__extension__ typedef unsigned __int128 limb64_pair;
#define NUMBER limb64
#include "../../src/numbers/digits/limbs_tmpl.h"
#define NUMBER limb64
#include "check_limbs_tmpl.h"
#endif

TEST(test_products)
{
    check_products_limb8();
    check_products_limb32();
#ifdef __SIZEOF_INT128__
    check_products_limb64();
#endif
}

TEST(test_quotients)
{
    check_quotients_limb8();
    check_quotients_limb32();
#ifdef __SIZEOF_INT128__
    check_quotients_limb64();
#endif
}

static void put(limb8 *limbs, int size, uint64_t x)
{
    for (int i = 0; i < size; i++)
        limbs[i] = (limb8)(x >> (8 * i));
}

static uint64_t value(const limb8 *limbs, int size)
{
    uint64_t x = 0;
    for (int i = 0; i < size; i++)
        x |= (uint64_t)limbs[i] << (8 * i);
    return x;
}

/* Each of three limbs, squared and by each of one limb that changes carries. */
TEST(test_every_product)
{
    for (uint32_t x = 0; x < 1 << 24; x++) {
        limb8 limbs[3], square[6], product[4], y = (limb8)(x * 0x9e3779b9 >> 24);
        put(limbs, 3, x);
        limbs_sqr_limb8(square, limbs, 3);
        limbs_mul_limb8(product, limbs, 3, &y, 1);
        if (value(square, 6) != (uint64_t)x * x || value(product, 4) != (uint64_t)x * y)
            ck_abort_msg("%x, by itself or by %x", x, (unsigned)y);
    }
}

/* Two limbs by two, of which one is any and the other 0, 1, 2, the greatest or one bit in each. */
TEST(test_every_pair)
{
    static const limb8 special[] = {0, 1, 2, 4, 8, 16, 32, 64, 127, 128, 129, 254, 255};
    enum { SPECIAL = sizeof special };
    for (uint32_t pair = 0; pair < SPECIAL * SPECIAL; pair++) {
        limb8 y[2] = {special[pair % SPECIAL], special[pair / SPECIAL]}, x[2], product[4];
        for (uint32_t any = 0; any < 1 << 16; any++) {
            put(x, 2, any);
            limbs_mul_limb8(product, x, 2, y, 2);
            if (value(product, 4) != any * value(y, 2))
                ck_abort_msg("%x by %x", any, (unsigned)value(y, 2));
        }
    }
}

/* One digit of n / d, which is q with the rest given. */
static void check_digit(const limb8 *limbs, int size, uint64_t d, uint64_t q, uint64_t rest)
{
    limb8 n[4], quotient[2], left[5];
    put(n, size + 1, q * d + rest);
    limbs_tdiv_qr_limb8(quotient, left, 0, n, size + 1, limbs, size);
    if (value(quotient, 2) != q || value(left, size) != rest)
        ck_abort_msg("%lx times %lx, and %lx", (unsigned long)d, (unsigned long)q,
                     (unsigned long)rest);
}

/* Every digit of one limb and two more values of a second, at both ends of its rests: where the
 * rest is 0 no guess is too great by more, where it is d - 1 none is nearer to being too small. */
static void check_digits(uint64_t d, int size)
{
    limb8 limbs[3];
    put(limbs, size, d);
    for (uint64_t q = 0; q < 256; q++) {
        check_digit(limbs, size, d, q, 0);
        check_digit(limbs, size, d, q, d - 1);
    }
}

/* Divisors of one and two limbs, all of them; of three, all leading ones with a third limb that
 * matters least and most. A guess from two limbs can be wrong for the third alone. */
TEST(test_every_digit)
{
    static const limb8 third[] = {0, 128, 255};
    for (uint64_t d = 128; d < 256; d++)
        for (uint64_t n = 0; n < 1 << 16; n++)
            check_digit((limb8[]){(limb8)d}, 1, d, n / d, n % d);
    for (uint64_t d = 1 << 15; d < 1 << 16; d++) {
        check_digits(d, 2);
        for (size_t i = 0; i < sizeof third; i++)
            check_digits(d << 8 | third[i], 3);
    }
}

SUITE("limbs")
