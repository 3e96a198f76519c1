/* SPDX-License-Identifier: MIT */
/* The time that this thread has computed, in nanoseconds: what others do on the machine does not
 * count. */
#pragma once

#include <time.h>

static inline double cpu_time(void)
{
    struct timespec at;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &at);
    return (double)at.tv_sec * 1e9 + (double)at.tv_nsec;
}
