/* SPDX-License-Identifier: MIT */
/* How many executions there were and how many of them compared something: two numbers of 64 bits
 * in the file that FUZZ_COUNTS names. It is mapped, so that nothing is lost however a process ends,
 * and shared by all that count. Without a file nothing is counted. */
#pragma once

#include <stdbool.h>

/* False when there should be a file, and there is none of that size. */
bool fuzz_counts_open(void);

void fuzz_count_execution(void);
void fuzz_count_compared(bool compared);
