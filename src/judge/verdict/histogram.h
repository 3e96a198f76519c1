/* Errors counted by size, so that any share of them can be asked for afterwards. A size >= 0 falls
 * into one of 32 equal parts of its binade: whole numbers to 64 are told apart, larger sizes to one
 * part in 32, upwards. The largest is kept as it is. */
#ifndef JUDGE_HISTOGRAM_H
#define JUDGE_HISTOGRAM_H

#include <stdint.h>

#define HISTOGRAM_BINS 65536 /* the upper 16 bits of a double >= 0, infinity included */

typedef struct {
    uint64_t count, zeros;
    double most;
    uint32_t bins[HISTOGRAM_BINS];
} histogram;

void histogram_clear(histogram *all);

/* A NaN counts as infinite. */
void histogram_add(histogram *all, double size);

/* The least size, rounded up to a bin's end, that at least that share of the sizes does not exceed;
 * 0 when there are none. */
double histogram_quantile(const histogram *all, double share);

#endif
