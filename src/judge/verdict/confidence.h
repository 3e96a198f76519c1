/* How sure a share is that was counted. */
#ifndef JUDGE_CONFIDENCE_H
#define JUDGE_CONFIDENCE_H

#include <stdint.h>

typedef struct {
    double lower, upper;
} confidence;

/* Wilson's score interval: of all such cases, between these shares of them are counted, in 95 of
 * 100 such samples. It holds for few and for none: 0 of n is up to 3.84 / (n + 3.84). Without a
 * sample nothing is known: 0 to 1. */
confidence confidence_of(uint64_t counted, uint64_t sample);

#endif
