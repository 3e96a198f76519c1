/* SPDX-License-Identifier: MIT */
/* Doubles as text that says every bit. */
#pragma once

#include "../bits.h"

#include <inttypes.h>
#include <stdio.h>

/* The longest is -0x1.fffffffffffffp-1022; compilers that don't see it leave room for any int. */
typedef struct {
    char text[34];
} hex_float_text;

/* As %a, of which C leaves something open that is settled here, as glibc has it: one digit before
 * the point, 0 for a subnormal, and no zeros at the end. */
static inline hex_float_text hex_float(double x)
{
    uint64_t fraction = bits_of(x) & BITS_FRACTION;
    int power = exponent_of(x), digits = 13, first = power >= -1022;
    const char *sign = is_negative_bits(x) ? "-" : "";
    hex_float_text hex;
    if (power == 1024) {
        snprintf(hex.text, sizeof hex.text, "%s%s", sign, fraction != 0 ? "nan" : "inf");
        return hex;
    }
    if (!first)
        power = fraction == 0 ? 0 : -1022;
    for (; digits > 0 && (fraction & 15) == 0; fraction >>= 4)
        digits--;
    if (digits == 0)
        snprintf(hex.text, sizeof hex.text, "%s0x%dp%+d", sign, first, power);
    else
        snprintf(hex.text, sizeof hex.text, "%s0x%d.%0*" PRIx64 "p%+d", sign, first, digits,
                 fraction, power);
    return hex;
}

/* An argument for %s. */
#define HEX(x) (hex_float(x).text)
