/* SPDX-License-Identifier: MIT */
/* The caller's floating-point environment. The stages after the first need round to nearest, and
 * nothing else: what is flushed, their bounds hold.
 *
 *     TO_NEAREST(answer, decide(...));
 *
 * decide must be NOT_INLINED: compilers move arithmetic across a change of
 * the environment. Exception flags that it raises are dropped by the second way and stay by the
 * first. */
#pragma once

#include <stdbool.h>

#if defined(__x86_64__) && defined(__SSE2_MATH__) && defined(__GNUC__)
#define ENVIRONMENT_IS_MXCSR
typedef unsigned environment;
#else
#include <fenv.h>
typedef fenv_t environment;
#endif

/* Is the rounding mode to nearest? Upwards 1 + 2^-60 is above 1; downwards and towards zero
 * 1 - 2^-60 is below. Volatile, so that it is done here and now. */
static inline bool environment_is_nearest(void)
{
    volatile double tiny = 0x1p-60;
    double x = tiny;
    volatile double above = 1 + x, below = 1 - x;
    return above == below;
}

/* To the default environment: round to nearest, gradual underflow, no traps. */
static inline void environment_enter(environment *saved)
{
#ifdef ENVIRONMENT_IS_MXCSR
    *saved = __builtin_ia32_stmxcsr();
    __builtin_ia32_ldmxcsr(0x1f80);
#else
    fegetenv(saved);
    fesetenv(FE_DFL_ENV);
#endif
}

/* Back to the environment and the exception flags of before. */
static inline void environment_leave(const environment *saved)
{
#ifdef ENVIRONMENT_IS_MXCSR
    __builtin_ia32_ldmxcsr(*saved);
#else
    fesetenv(saved);
#endif
}

/* result = call, in an environment that rounds to nearest. */
#define TO_NEAREST(result, call) ENVIRONMENT_SET(environment_is_nearest(), result, call)
#define ENVIRONMENT_SET(is_set, result, call)                                                      \
    do {                                                                                           \
        if (is_set) {                                                                              \
            result = call;                                                                         \
        } else {                                                                                   \
            environment saved;                                                                     \
            environment_enter(&saved);                                                             \
            result = call;                                                                         \
            environment_leave(&saved);                                                             \
        }                                                                                          \
    } while (0)
