/* SPDX-License-Identifier: MIT */
/* FROZEN (naive.h). */
#include "naive_block.h"

#include <stdlib.h>

#ifdef NAIVE_WIDE
extern naive_hits *const naive_hits_4[], *const naive_hits_8[];

naive_hits *naive_hits_of(sure_shape shape)
{
    const char *lanes = getenv("SUREHIT_LANES");
    const int most = lanes ? lanes[0] - '0' : 8;
    if (most >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return naive_hits_8[shape];
    return most >= 4 && __builtin_cpu_supports("avx2") ? naive_hits_4[shape] : NULL;
}
#else
naive_hits *naive_hits_of(sure_shape shape)
{
    (void)shape;
    return NULL;
}
#endif
