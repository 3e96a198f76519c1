/* A program that is given a text on its standard input and whose standard output is kept: a whole
 * life at a time, so that it does not matter how it buffers. */
#ifndef JUDGE_PIPE_H
#define JUDGE_PIPE_H

#include "../verdict/reply.h"

/* ANSWERED: it ended by itself. HUNG: it neither read nor wrote for as long as the time limit, and
 * was ended; LOST: it wrote more than it was allowed to, and was ended. UNASKED: no process, no
 * memory. */
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

#endif
