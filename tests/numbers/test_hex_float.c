/* SPDX-License-Identifier: MIT */
/* The text of doubles (hex_float.h) in every class of bits: read back they are the same, and where
 * the C library is glibc the text is what it writes by %a. */
#include "../support/suite.h"

#include "../../src/numbers/digits/hex_float.h"

static void check(uint64_t bits)
{
    double x = double_of(bits);
    hex_float_text hex = hex_float(x);
    char *end = NULL;
    double back = strtod(hex.text, &end);
    bool same = isnan(x) ? isnan(back) : bits_of(back) == bits;
    if (!same || *end != '\0')
        ck_abort_msg("%016" PRIx64 " is not %s", bits, hex.text);
#ifdef __GLIBC__
    char wanted[64];
    snprintf(wanted, sizeof wanted, "%a", x);
    ck_assert_str_eq(hex.text, wanted);
#endif
}

/* Every sign and exponent, with fractions of one bit, of all bits up to one and from one on, 0, and
 * one at random. */
TEST(test_every_class)
{
    for (uint64_t head = 0; head < 1 << 12; head++) {
        check(head << 52);
        check(head << 52 | suite_bits(1, head) >> 12);
        for (int bit = 0; bit < 52; bit++) {
            uint64_t one = UINT64_C(1) << bit;
            check(head << 52 | one);
            check(head << 52 | (one - 1));
            check(head << 52 | (BITS_FRACTION & ~(one - 1)));
        }
    }
}

/* Every digit in every place, of a normal number and a subnormal one. */
TEST(test_every_digit)
{
    for (uint64_t digit = 0; digit < 16; digit++) {
        for (int place = 0; place < 52; place += 4) {
            check(UINT64_C(0x3ff) << 52 | digit << place);
            check(digit << place);
        }
    }
}

SUITE("hex_float")
