/* SPDX-License-Identifier: MIT */
/* The floating-point environments that the contract names: rounding modes, subnormals flushed or
 * not. */
#pragma once

#include <fenv.h>
#include <stdbool.h>
#include <stdio.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

/* Number 0 is the usual one: to nearest, nothing flushed. By fours: nothing flushed; subnormal
 * results and operands; and, for which no program asks, results alone and operands alone. */
#ifdef __SSE2__
enum { SURROUNDINGS_MODES = 4, SURROUNDINGS = 8, SURROUNDINGS_ALL = 16 };
#else
enum { SURROUNDINGS_MODES = 4, SURROUNDINGS = 4, SURROUNDINGS_ALL = 4 };
#endif

/* What depends on them must be out of the compiler's sight. */
static inline void surroundings_set(int number)
{
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    fesetround(modes[number % SURROUNDINGS_MODES]);
#ifdef __SSE2__
    static const unsigned flushes[] = {0, 0x8040, 0x8000, 0x0040}; /* FTZ, DAZ */
    _mm_setcsr((_mm_getcsr() & ~0x8040U) | flushes[number / SURROUNDINGS_MODES]);
#endif
}

/* The default environment but for these. */
static inline void surroundings_enter(int number)
{
    fesetenv(FE_DFL_ENV);
    surroundings_set(number);
}

/* Has nothing changed since then but the exception flags? It is entered again. */
static inline bool surroundings_kept(int number)
{
    int mode = fegetround();
#ifdef __SSE2__
    const unsigned control_bits = 0xffc0; /* of MXCSR */
    unsigned before = _mm_getcsr() & control_bits;
    surroundings_enter(number);
    return mode == fegetround() && before == (_mm_getcsr() & control_bits);
#else
    surroundings_enter(number);
    return mode == fegetround();
#endif
}

/* "up, operands flushed" */
static inline const char *surroundings_name(int number)
{
    static const char *const modes[] = {"to nearest", "up", "down", "toward zero"};
    static const char *const flushes[] = {"", ", flushed", ", results flushed",
                                          ", operands flushed"};
    static char name[32];
    snprintf(name, sizeof name, "%s%s", modes[number % SURROUNDINGS_MODES],
             flushes[number / SURROUNDINGS_MODES]);
    return name;
}
