/* SPDX-License-Identifier: MIT */
#include "reply.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

void reply_print_end(int ended, char line[CASE_LINE_MAX])
{
    if (WIFSIGNALED(ended))
        snprintf(line, CASE_LINE_MAX, "crash: signal %d, %s", WTERMSIG(ended),
                 strsignal(WTERMSIG(ended)));
    else
        snprintf(line, CASE_LINE_MAX, "crash: exit status %d", WEXITSTATUS(ended));
}
