/* SPDX-License-Identifier: MIT */
#include "block.h"

#include <stdlib.h>

/* At most so many side by side; WebAssembly has no environment. */
#if defined SURE_LANES_X86 || (defined SURE_LANES_2 && !defined __wasm__)
static int allowed(void)
{
    const char *most = getenv("SUREHIT_LANES");
    return most ? most[0] - '0' : 8;
}
#endif

/* The widest of what this processor has. */
#if defined SURE_LANES_X86
#define STAGES(of)                                                                                 \
    block_stage *const *block_stages##of(void)                                                     \
    {                                                                                              \
        const int most = allowed();                                                                \
        if (most >= 8 && __builtin_cpu_supports("avx512f") &&                                      \
            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&            \
            __builtin_cpu_supports("avx512vl"))                                                    \
            return block_stages_8##of;                                                             \
        return most >= 4 && __builtin_cpu_supports("avx2") ? block_stages_4##of : NULL;            \
    }
#elif defined SURE_LANES_2 && defined __wasm__
#define STAGES(of)                                                                                 \
    block_stage *const *block_stages##of(void)                                                     \
    {                                                                                              \
        return block_stages_2##of;                                                                 \
    }
#elif defined SURE_LANES_2
#define STAGES(of)                                                                                 \
    block_stage *const *block_stages##of(void)                                                     \
    {                                                                                              \
        return allowed() >= 2 ? block_stages_2##of : NULL;                                         \
    }
#else
#define STAGES(of)                                                                                 \
    block_stage *const *block_stages##of(void)                                                     \
    {                                                                                              \
        return NULL;                                                                               \
    }
#endif
STAGES()
STAGES(_f)
