/* SPDX-License-Identifier: MIT */
/* Programs that are spoken to by their standard input and output. */
#pragma once

#include "../verdict/reply.h"
#include "child.h"

/* ANSWERED: it ended by itself, or has answered and is kept; HUNG: it neither read nor wrote for as
 * long as the time limit, and was ended; LOST: it wrote more than it was allowed to, and was ended;
 * UNASKED: no process, no memory. */
typedef struct {
    reply_kind kind;
    int ended;  /* how, as waitpid tells */
    char *text; /* what it wrote, a NUL behind it; to be freed */
    size_t length;
    double nanoseconds; /* that it computed: its children, too, unless it is kept */
    double growth;      /* bytes that it grew by from its first words to its last, */
    int growths;        /* in so many steps; 0 of one that is kept */
} pipe_result;

/* Runs the command as a shell would, a whole life at a time, so that it does not matter how it
 * buffers. Exit status 127: there is none such. */
pipe_result pipe_run(const char *command, const char *text, size_t length, size_t most,
                     double time_limit);

/* One that is kept: started, and given text after text until child_stop. */
bool pipe_open(child *process, const char *command);

/* Its answer is `bytes` long, or, where that is 0, as far as an empty line. Where it is not whole
 * there is no process any more: its id is 0. */
pipe_result pipe_ask(child *process, const char *text, size_t length, size_t bytes, size_t most,
                     double time_limit);
