/* SPDX-License-Identifier: MIT */
/* The quadratic: its laws in every tier, of polynomials of all kinds. */
#include "fuzz.h"
#include "quadratic_laws.h"

FUZZ_TARGET("quadratic", fuzz_mutate_doubles)

/* Decoding. */

static double wide(fuzz_bytes *bytes)
{
    double high = fuzz_signed(bytes);
    return 65536 * high + 256 * fuzz_signed(bytes) + 1;
}

static polynomial shifted(polynomial p, fuzz_bytes *bytes)
{
    int k = 8 * (int8_t)fuzz_byte(bytes), of_t = 4 * (int8_t)fuzz_byte(bytes);
    return (polynomial){ldexp(p.a, k + of_t), ldexp(p.h, k), ldexp(p.c, k - of_t)};
}

static polynomial moved(polynomial p, fuzz_bytes *bytes)
{
    p.a = fuzz_ulps(p.a, (int8_t)fuzz_byte(bytes) / 16);
    p.h = fuzz_ulps(p.h, (int8_t)fuzz_byte(bytes) / 16);
    p.c = fuzz_ulps(p.c, (int8_t)fuzz_byte(bytes) / 16);
    return p;
}

/* s (x t + y)^2, with x and y of up to 23 bits: D/4 is 0, and no product is rounded. */
static polynomial tangent(fuzz_bytes *bytes)
{
    double s = fuzz_signed(bytes), x = wide(bytes), y = wide(bytes);
    return (polynomial){s * x * x, s * x * y, s * y * y};
}

/* 2 (x t - y) (z t - w) */
static polynomial rational(fuzz_bytes *bytes)
{
    double x = fuzz_signed(bytes), y = fuzz_signed(bytes), z = fuzz_signed(bytes),
           w = fuzz_signed(bytes);
    return (polynomial){2 * x * z, -(x * w + y * z), 2 * y * w};
}

static polynomial read_numbers(fuzz_bytes *bytes, double (*read)(fuzz_bytes *))
{
    sure_vec3 v = fuzz_vector(bytes, read);
    return (polynomial){v.x, v.y, v.z};
}

static polynomial read_polynomial(fuzz_bytes *bytes)
{
    uint8_t how = fuzz_byte(bytes);
    polynomial p;
    switch (how % 4) {
    case 0: return read_numbers(bytes, fuzz_double);
    case 1: p = read_numbers(bytes, fuzz_shaped_double); break;
    case 2: p = tangent(bytes); break;
    default: p = rational(bytes); break;
    }
    if (how & 4)
        p = shifted(p, bytes);
    return how & 8 ? moved(p, bytes) : p;
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    int k = (int8_t)fuzz_byte(&bytes);
    polynomial p = read_polynomial(&bytes);
    if (!is_finite(p))
        return false;
    fuzz_ask("a %a half_b %a c %a", p.a, p.h, p.c);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        fuzz_by(tier);
        quadratic_check(p, tier, k);
    }
    return true;
}
