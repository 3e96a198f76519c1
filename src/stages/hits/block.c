/* SPDX-License-Identifier: MIT */
#include "block.h"
#include "../../tracer/packet.h"

#include <stdlib.h>

#if defined SURE_LANES_X86 || defined SURE_LANES_2
/* The widest of what this processor has, where that is at most so wide. */
static block_stage *const *stages_of(int most)
{
#ifdef SURE_LANES_X86
    if (most >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return block_stages_8;
    if (most >= 4 && __builtin_cpu_supports("avx2"))
        return block_stages_4;
#endif
#ifdef SURE_LANES_2
    if (most >= 2)
        return block_stages_2;
#endif
    return NULL;
}

block_stage *const *block_stages(void)
{
    const char *most = getenv("SUREHIT_LANES");
    return stages_of(most ? most[0] - '0' : 8);
}
#else
block_stage *const *block_stages(void)
{
    return NULL;
}
#endif

const packet_walks *packet_walks_here(void)
{
    block_stage *const *stages = block_stages();
#ifdef SURE_LANES_X86
    if (stages)
        return stages == block_stages_8 ? &packet_walks_8 : &packet_walks_4;
#endif
#ifdef SURE_LANES_2
    if (stages)
        return &packet_walks_2;
#endif
    (void)stages;
    return NULL;
}
