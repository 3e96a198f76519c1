/* SPDX-License-Identifier: MIT */
/* The time that a piece may take, and after which of it what is done is kept: the processor's, and
 * that of waiting for programs that work for it. */
#pragma once

#include <stdbool.h>

typedef struct {
    double keep, kept, limit; /* ns, all threads together */
} allowance;

/* What is done is kept every `keep` seconds; after `limit` of them (0: none) it ends. Long after
 * that the system ends the program, which was somewhere without an end. */
allowance allowance_of(double keep, unsigned long limit);

typedef enum { ALLOWANCE_LEFT, ALLOWANCE_DUE, ALLOWANCE_OVER } allowance_state;

/* DUE: what is done is to be kept, and then allowance_kept to be told. */
allowance_state allowance_look(const allowance *of);
void allowance_kept(allowance *of);

/* So many ns were spent waiting for a program. By one thread. */
void allowance_waited(double nanoseconds);
