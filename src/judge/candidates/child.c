/* SPDX-License-Identifier: MIT */
#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

void child_begins(void)
{
    const struct rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    signal(SIGPIPE, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

static void close_both(const int ends[2])
{
    close(ends[0]);
    close(ends[1]);
}

bool child_start(child *self, child_life *live, const void *context)
{
    int in[2], out[2];
    *self = (child){.input = -1, .output = -1};
    if (pipe2(in, O_CLOEXEC) != 0)
        return false;
    if (pipe2(out, O_CLOEXEC) != 0) {
        close_both(in);
        return false;
    }
    fflush(NULL); /* nothing that is buffered may be written twice */
    pid_t id = fork();
    if (id == 0) {
        child_begins();
        close(in[1]);
        close(out[0]);
        live(context, in[0], out[1]);
        _exit(EXIT_FAILURE);
    }
    close(in[0]);
    close(out[1]);
    if (id < 0) {
        close(in[1]);
        close(out[0]);
        return false;
    }
    *self = (child){.id = id, .input = in[1], .output = out[0]};
    return true;
}

void child_close_input(child *self)
{
    if (self->input >= 0)
        close(self->input);
    self->input = -1;
}

void child_bury(child *self)
{
    child_close_input(self);
    close(self->output);
    while (waitpid(self->id, &self->ended, 0) < 0 && errno == EINTR)
        ;
    self->id = 0;
    self->output = -1;
}

void child_stop(child *self)
{
    if (self->id == 0)
        return;
    kill(self->id, SIGKILL);
    child_bury(self);
}
