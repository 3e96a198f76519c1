/* SPDX-License-Identifier: MIT */
/* The processes that the judge starts. */
#pragma once

#include <poll.h>
#include <stdbool.h>
#include <sys/types.h>

/* What each of them does first: a crash leaves no file behind, a hang not even itself when the
 * judge is interrupted, and a pipe that nobody reads ends it as usual. */
void child_begins(void);

/* One that is spoken to by two pipes. */
typedef struct {
    pid_t id;          /* 0: none */
    int input, output; /* its; -1: closed */
    int ended;         /* how, as waitpid tells */
} child;

/* Starts it: `live` is its whole life, and reads from `in` and writes to `out`. False: no process,
 * and errno says why. */
typedef void child_life(const void *context, int in, int out);
bool child_start(child *self, child_life *live, const void *context);

void child_close_input(child *self);

/* poll, whose time counts as that of a piece. */
int child_poll(struct pollfd *of, nfds_t count, int milliseconds);

/* Ends it now, if there is one, and those that it has started. */
void child_stop(child *self);

/* Does it end by itself, within so many seconds? Then those that it has started are ended, and what
 * it used goes to `used`, if that is not NULL. */
struct rusage;
bool child_ends(child *self, double time_limit, struct rusage *used);
