/* SPDX-License-Identifier: MIT */
/* The floating-point environments that the contract names: rounding modes, subnormals flushed or
 * not. */
#pragma once

#include <fenv.h>
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
