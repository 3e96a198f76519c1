/* The processes that the judge starts. */
#pragma once

#include "../verdict/reply.h"

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

/* Closes both pipes and waits until it has ended. */
void child_bury(child *self);

/* Ends it, if there is one and it has not ended by itself. */
void child_stop(child *self);

/* A program that is given a text on its standard input and whose standard output is kept: a whole
 * life at a time, so that it does not matter how it buffers. ANSWERED: it ended by itself; HUNG: it
 * neither read nor wrote for as long as the time limit, and was ended; LOST: it wrote more than it
 * was allowed to, and was ended; UNASKED: no process, no memory. */
typedef struct {
    reply_kind kind;
    int ended;  /* how, as waitpid tells */
    char *text; /* what it wrote, a NUL behind it; to be freed */
    size_t length;
    double nanoseconds; /* that it and its children computed */
    double growth;      /* bytes that it grew by from its first words to its last */
    int growths;        /* in so many steps */
} pipe_result;

/* Runs the command as a shell would. Exit status 127: there is none such. */
pipe_result pipe_run(const char *command, const char *text, size_t length, size_t most,
                     double time_limit);
