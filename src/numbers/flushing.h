/* SPDX-License-Identifier: MIT */
/* Environments that flush subnormals: who may not be in one, and who wants to be. */
#pragma once

#include "bits.h"
#include "environment.h"

/* Is the rounding mode to nearest, and are no subnormals flushed, results or operands? Then twice
 * the least double is 2 of it. By its sums, since to read the environment itself takes some
 * processors longer; they wait for nothing. */
static inline bool environment_is_default(void)
{
    static const volatile double tiny = 0x1p-60, least = 0x1p-1074;
    double x = tiny, y = least;
    return ((bits_of(1 + x) ^ bits_of(1 - x)) | (bits_of(y + y) ^ 2)) == 0;
}

/* From here on subnormals count as zero, results and operands: some processors multiply them
 * slowly, and a point beside a plane through 0 has one. Only on x86-64, and in round to nearest: in
 * the other modes a sum tells a subnormal from zero. */
static inline void environment_flush(environment *saved)
{
#ifdef ENVIRONMENT_IS_MXCSR
    *saved = __builtin_ia32_stmxcsr();
    const bool directed = (*saved & 0x6000) != 0;
    __builtin_ia32_ldmxcsr(*saved | (directed ? 0 : 0x8040)); /* FTZ, DAZ */
#else
    fegetenv(saved);
#endif
}

/* result = call, in the default environment. */
#define TO_DEFAULT(result, call) ENVIRONMENT_SET(environment_is_default(), result, call)
