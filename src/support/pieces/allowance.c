/* SPDX-License-Identifier: MIT */
#include "allowance.h"

#include <math.h>
#include <sys/resource.h>
#include <time.h>

/* Seconds beyond the limit, after which there is no end. */
#define BEYOND 60

static double waited;

static double spent(void)
{
    struct timespec at;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return (double)at.tv_sec * 1e9 + (double)at.tv_nsec + waited;
}

void allowance_waited(double nanoseconds)
{
    waited += nanoseconds;
}

allowance allowance_of(double keep, unsigned long limit)
{
    struct rlimit seconds;
    if (limit > 0 && getrlimit(RLIMIT_CPU, &seconds) == 0 && limit + BEYOND < seconds.rlim_max) {
        seconds.rlim_cur = limit + BEYOND;
        setrlimit(RLIMIT_CPU, &seconds);
    }
    return (allowance){1e9 * keep, spent(), limit > 0 ? 1e9 * (double)limit : INFINITY};
}

allowance_state allowance_look(const allowance *of)
{
    double now = spent();
    if (now > of->limit)
        return ALLOWANCE_OVER;
    return now - of->kept >= of->keep ? ALLOWANCE_DUE : ALLOWANCE_LEFT;
}

void allowance_kept(allowance *of)
{
    of->kept = spent();
}
