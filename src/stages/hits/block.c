/* SPDX-License-Identifier: MIT */
#include "block.h"

#include <stdatomic.h>
#include <stdlib.h>

#if defined SURE_LANES_X86
/* The widest of what this processor has, at most so many. */
static int widest(int most)
{
    if (most < 4 || !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi"))
        return 1;
    bool wider = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                 __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
    return most >= 8 && wider ? 8 : 4;
}
#define WIDTHS(X, of) X(4, of) X(8, of)
#elif defined SURE_LANES_2
static int widest(int most)
{
    return most >= 2 ? 2 : 1;
}
#define WIDTHS(X, of) X(2, of)
#else
static int widest(int most)
{
    (void)most;
    return 1;
}
#define WIDTHS(X, of)
#endif

#ifdef __wasm__ /* has no environment */
int block_lanes(void)
{
    return widest(2);
}
#else
static atomic_int known; /* 0: not yet */

int block_lanes_most(int most)
{
    const int found = widest(most);
    atomic_store_explicit(&known, found, memory_order_relaxed);
    return found;
}

int block_lanes(void)
{
    const int found = atomic_load_explicit(&known, memory_order_relaxed);
    if (found > 0)
        return found;
    const char *most = getenv("SUREHIT_LANES");
    return block_lanes_most(most ? most[0] - '0' : BLOCK_WIDEST);
}
#endif

#define ROW(lanes, of)                                                                             \
    case lanes:                                                                                    \
        return block_stages_##lanes##of;
#define STAGES(of)                                                                                 \
    const block_stage *block_stages##of(void)                                                      \
    {                                                                                              \
        switch (block_lanes()) {                                                                   \
            WIDTHS(ROW, of)                                                                        \
        default: return NULL;                                                                      \
        }                                                                                          \
    }
STAGES()
STAGES(_f)
