#include "confidence.h"

#include <math.h>

/* The normal law has 95 % within this many standard deviations. */
#define DEVIATIONS 1.959963984540054

/* The two p at which the counted share k/n is DEVIATIONS of sqrt(p (1 - p) / n) away from p: the
 * roots of a quadratic. */
confidence confidence_of(uint64_t counted, uint64_t sample)
{
    if (sample == 0)
        return (confidence){0, 1};
    double n = (double)sample, k = (double)counted, square = DEVIATIONS * DEVIATIONS;
    double middle = k + square / 2;
    double spread = DEVIATIONS * sqrt(k * (n - k) / n + square / 4);
    double whole = n + square;
    return (confidence){counted == 0 ? 0 : (middle - spread) / whole,
                        counted == sample ? 1 : (middle + spread) / whole};
}
