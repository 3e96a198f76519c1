#include "histogram.h"

#include <math.h>
#include <string.h>

#define SHIFT 47 /* sign, eleven bits of exponent and five of the mantissa are left: below 2^16 */

void histogram_clear(histogram *all)
{
    if (all->count > 0)
        memset(all, 0, sizeof *all);
}

void histogram_add(histogram *all, double size)
{
    uint64_t bits;
    if (isnan(size))
        size = INFINITY;
    memcpy(&bits, &size, sizeof bits);
    all->bins[bits >> SHIFT]++;
    all->count++;
    all->zeros += size == 0;
    if (size > all->most)
        all->most = size;
}

/* The least number above all of the bin's. */
static double end_of(uint64_t bin)
{
    double end;
    uint64_t bits = (bin + 1) << SHIFT;
    memcpy(&end, &bits, sizeof end);
    return end;
}

double histogram_quantile(const histogram *all, double share)
{
    double wanted = ceil(share * (double)all->count), seen = (double)all->zeros;
    if (seen >= wanted)
        return 0;
    seen = 0;
    for (uint64_t bin = 0; bin < HISTOGRAM_BINS; bin++) {
        seen += all->bins[bin];
        if (seen >= wanted) {
            double end = end_of(bin); /* a NaN behind infinity's bin */
            return end < all->most ? end : all->most;
        }
    }
    return all->most;
}
