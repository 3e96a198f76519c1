/* Was the processor's core all ours? What runs on its other half makes code that keeps every unit
 * busy up to twice as slow, and code that waits for its own results hardly: no ratio of such times
 * means anything then, and no clock tells. A fixed calculation does. For one thread. */
#ifndef JUDGE_NOISE_PROBE_H
#define JUDGE_NOISE_PROBE_H

/* How many times the least time that the calculation ever took, in a few microseconds. */
double noise_probe(void);

/* Noise that counts as none. Measured on a shared machine: 1.00 to 1.07, or 1.34 to 2. */
#define NOISE_MOST 1.1

/* How many of these, in ascending order, count as none: as above, or the first `enough` of them, or
 * all. */
int noise_quiet(const double *noise, int count, int enough);

#endif
