/* Was the processor's core all ours? What runs on its other half makes code that keeps every unit
 * busy up to twice as slow, and code that waits for its own results hardly: no ratio of such times
 * means anything then, and no clock tells. A fixed calculation does. For one thread. */
#ifndef JUDGE_QUIET_H
#define JUDGE_QUIET_H

/* How many times the least time that the calculation ever took, in a few microseconds. */
double quiet_noise(void);

#define QUIET_MOST 1.1 /* noise that counts as none */

/* How much noise counts as none among these, in ascending order: as above, or what it takes for
 * `enough` of them to count, or all. */
double quiet_limit(const double *noise, int count, int enough);

#endif
