/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include "case.h"
#include "../src/numbers/bits.h"

#include <stdarg.h>

_Noreturn void fuzz_find(const char *law, const char *text)
{
    fprintf(stderr, "find: %s: %s\n%s\n", fuzz_name, law, text ? text : "");
    fflush(stderr);
    abort();
}

static char asked[4096];
static const char *asked_by; /* NULL for none */

void fuzz_ask(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(asked, sizeof asked, format, arguments);
    va_end(arguments);
}

void fuzz_by(sure_tier tier)
{
    asked_by = sure_tier_name(tier);
}

void expect(bool holds, const char *law)
{
    char what[160];
    if (holds)
        return;
    snprintf(what, sizeof what, "%s%s%s", asked_by ? asked_by : "", asked_by ? ": " : "", law);
    fuzz_find(what, asked);
}

void fuzz_promised(sure_tier tier, const char *broken)
{
    fuzz_by(tier);
    expect(!broken, broken);
}

uint8_t fuzz_byte(fuzz_bytes *bytes)
{
    if (bytes->left == 0) {
        bytes->short_of = true;
        return 0;
    }
    bytes->left--;
    return *bytes->at++;
}

uint64_t fuzz_u64(fuzz_bytes *bytes)
{
    uint64_t value = 0;
    for (int i = 0; i < 8; i++)
        value |= (uint64_t)fuzz_byte(bytes) << 8 * i;
    return value;
}

double fuzz_double(fuzz_bytes *bytes)
{
    return double_of(fuzz_u64(bytes));
}

static const double specials[] = {0,          -0.0,        0x1p-1074,
                                  -0x1p-1074, 0x1p-1022,   0x1.ffffffffffffep-1023,
                                  1,          -1,          0x1.fffffffffffffp1023,
                                  0x1p1023,   INFINITY,    -INFINITY,
                                  NAN,        0x1p-600,    0x1p600,
                                  0x1p-1000,  0x1.8p-1073, -0x1.fffffffffffffp1023};

static double special(uint8_t which)
{
    return specials[which % (sizeof specials / sizeof *specials)];
}

double fuzz_signed(fuzz_bytes *bytes)
{
    return (int8_t)fuzz_byte(bytes);
}

double fuzz_share(fuzz_bytes *bytes)
{
    return fuzz_byte(bytes) / 255.0;
}

/* 16 bits and any exponent, down to the subnormals and up to infinity. */
static double shifted_integer(fuzz_bytes *bytes)
{
    int low = fuzz_byte(bytes), high = (int8_t)fuzz_byte(bytes), shift = (int8_t)fuzz_byte(bytes);
    int finer = fuzz_byte(bytes) % 9;
    return ldexp(256 * high + low, 8 * shift + finer);
}

double fuzz_shaped_double(fuzz_bytes *bytes)
{
    uint8_t kind = fuzz_byte(bytes);
    switch (kind % 8) {
    case 0: return fuzz_double(bytes);
    case 1:
    case 2: return shifted_integer(bytes);
    case 3: return fuzz_ulps(kind & 0x80 ? -1 : 1, (int8_t)fuzz_byte(bytes));
    case 4: return special(fuzz_byte(bytes));
    default: return fuzz_signed(bytes);
    }
}

sure_vec3 fuzz_vector(fuzz_bytes *bytes, double (*read)(fuzz_bytes *))
{
    double x = read(bytes), y = read(bytes), z = read(bytes);
    return (sure_vec3){x, y, z};
}

double fuzz_ulps(double x, int steps)
{
    double moved = step_ulps(x, steps);
    return isnan(x) ? x : isnan(moved) ? copysign(INFINITY, x) : moved;
}

uint64_t fuzz_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

static double flip_exponent(double x, uint64_t random)
{
    uint64_t bits = bits_of(x);
    if (random & 1)
        return double_of(bits ^ (uint64_t)1 << (52 + random / 2 % 11));
    uint64_t exponent = (bits >> 52 & 0x7ff) + random / 2 % 7 - 3;
    return double_of((bits & 0x800fffffffffffff) | (exponent & 0x7ff) << 52);
}

static double changed(double x, uint64_t random)
{
    uint64_t rest = random / 16;
    switch (random % 8) {
    case 0: return flip_exponent(x, rest);
    case 1: return fuzz_ulps(x, (int)(rest % 9) - 4);
    case 2: return -x;
    case 3: return (double)(rest % 2);
    case 4: return special((uint8_t)rest);
    case 5: return x + (double)(int)(rest % 17) - 8;
    case 6: return double_of(bits_of(x) & ~(uint64_t)0 << rest % 52);
    default: return isfinite(x) && fabs(x) < 1e15 ? nearbyint(x) : (double)(int)(rest % 201) - 100;
    }
}

size_t fuzz_mutate_doubles(uint8_t *data, size_t size, size_t max, unsigned seed)
{
    uint64_t state = seed;
    (void)max; /* the size stays */
    if (size < sizeof(double))
        return size;
    /* Doubles mostly fill the end of the bytes; what is before them says how to read them. */
    size_t first = size % sizeof(double), count = size / sizeof(double);
    for (uint64_t times = fuzz_random(&state) % 3 + 1; times > 0; times--) {
        uint64_t random = fuzz_random(&state);
        size_t at = first + (size_t)(fuzz_random(&state) % count) * sizeof(double);
        if (random % 8 == 0)
            at = (size_t)(fuzz_random(&state) % (size - sizeof(double) + 1));
        size_t from = first + (size_t)(fuzz_random(&state) % count) * sizeof(double);
        double x;
        memcpy(&x, random / 8 % 4 == 0 ? data + from : data + at, sizeof x);
        if (random / 8 % 8 != 0)
            x = changed(x, random / 64);
        memcpy(data + at, &x, sizeof x);
    }
    return size;
}
