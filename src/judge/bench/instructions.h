/* How many instructions this thread has run outside the kernel. Unlike times they repeat, on any
 * machine of the kind. */
#ifndef JUDGE_INSTRUCTIONS_H
#define JUDGE_INSTRUCTIONS_H

/* So far; -1 where the kernel or the processor does not count them. */
double instructions_now(void);

#endif
