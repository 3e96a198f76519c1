/* SPDX-License-Identifier: MIT */
#include "block.h"

#include <stdlib.h>

#if defined SURE_LANES_X86 || defined SURE_LANES_2
/* The widest of what this processor has, where that is at most so wide. */
static int lanes_of(int most)
{
#ifdef SURE_LANES_X86
    if (most >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return 8;
    if (most >= 4 && __builtin_cpu_supports("avx2"))
        return 4;
#endif
#ifdef SURE_LANES_2
    if (most >= 2)
        return 2;
#endif
    return 0;
}

int block_lanes(void)
{
    const char *most = getenv("SUREHIT_LANES");
    return lanes_of(most ? most[0] - '0' : 8);
}

block_stage *const *block_stages(void)
{
    switch (block_lanes()) {
#ifdef SURE_LANES_X86
    case 8: return block_stages_8;
    case 4: return block_stages_4;
#endif
#ifdef SURE_LANES_2
    case 2: return block_stages_2;
#endif
    default: return NULL;
    }
}
#else
int block_lanes(void)
{
    return 0;
}

block_stage *const *block_stages(void)
{
    return NULL;
}
#endif
