/* SPDX-License-Identifier: MIT */
/* Instructions, which repeat where times don't. A command that is to tell them is run once more
 * under valgrind's callgrind, which counts them: there cost_of gives instructions in the place of
 * nanoseconds. That run says its figures, and the first one takes them in the same order. */
#pragma once

#include <stdbool.h>

/* Of so many cases of a row at most they are counted. */
#define INSTRUCTIONS_CASES 512

/* Is this the run that counts? */
bool instructions_counting(void);

/* Has all that this program does counted, once its words are known to be right. False after a line
 * to standard error, which begins with the name. */
bool instructions_begin(const char *name);

/* In the run that counts says the figure, which it returns; else the next one that was said, -1 for
 * none. */
double instructions_figure(double counted);

/* Nanoseconds of processor time that run(context) takes, without what measuring takes; instructions
 * in the run that counts, -1 where none are told. */
double cost_of(void (*run)(void *context), void *context);
