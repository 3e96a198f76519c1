#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "noise_probe.h"

#include "../../support/cpu_time.h"

#include <math.h>
#include <stdint.h>

#define STEPS 2000
#define WARM_UP 100

/* Six chains that do not wait for each other: more work at once than there are units for it. */
static double probe(void)
{
    static volatile uint64_t kept;
    uint64_t a = 1 + kept, b = 2 + a, c = 3 + b, d = 4 + c, e = 5 + d, f = 6 + e;
    double start = cpu_time();
    for (int i = 0; i < STEPS; i++) {
        a += a >> 3;
        b ^= b << 5;
        c -= c >> 7;
        d ^= d >> 9;
        e += e << 2;
        f ^= f << 11;
    }
    kept = (a ^ b ^ c ^ d ^ e ^ f) & 1;
    return cpu_time() - start;
}

double noise_probe(void)
{
    static double least = INFINITY;
    for (int i = 0; i < WARM_UP && least == INFINITY; i++)
        probe();
    double time = probe();
    least = fmin(least, time);
    return least > 0 ? time / least : 1; /* 0 by a coarse clock */
}

int noise_quiet(const double *noise, int count, int enough)
{
    int quiet = enough < count ? enough : count;
    double limit = fmax(NOISE_MOST, noise[quiet - 1]);
    while (quiet < count && noise[quiet] <= limit)
        quiet++;
    return quiet;
}
