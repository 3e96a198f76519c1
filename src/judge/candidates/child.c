/* SPDX-License-Identifier: MIT */
#include "child.h"

#include "../../support/pieces/allowance.h"
#include "../../support/progress.h"

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
    struct rlimit seconds;
    setrlimit(RLIMIT_CORE, &none);
    if (getrlimit(RLIMIT_CPU, &seconds) == 0) { /* a piece's limit is its parent's alone */
        seconds.rlim_cur = seconds.rlim_max;
        setrlimit(RLIMIT_CPU, &seconds);
    }
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
        setpgid(0, 0); /* so that it can be ended with its children */
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
    setpgid(id, id);
    *self = (child){.id = id, .input = in[1], .output = out[0]};
    return true;
}

void child_close_input(child *self)
{
    if (self->input >= 0)
        close(self->input);
    self->input = -1;
}

/* Nothing of it is left. */
static void bury(child *self)
{
    child_close_input(self);
    close(self->output);
    self->id = 0;
    self->output = -1;
}

int child_poll(struct pollfd *of, nfds_t count, int milliseconds)
{
    double begun = progress_clock();
    int ready = poll(of, count, milliseconds);
    allowance_waited(1e9 * (progress_clock() - begun));
    return ready;
}

bool child_ends(child *self, double time_limit, struct rusage *used)
{
    child_close_input(self);
    for (double begun = progress_clock();;) {
        siginfo_t end = {.si_pid = 0};
        if (waitid(P_PID, (id_t)self->id, &end, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            end.si_pid == self->id) {
            kill(-self->id, SIGKILL); /* whom it has left behind */
            wait4(self->id, &self->ended, 0, used);
            bury(self);
            return true;
        }
        if (progress_clock() - begun >= time_limit)
            return false;
        child_poll(NULL, 0, 1); /* a millisecond */
    }
}

void child_stop(child *self)
{
    if (self->id == 0)
        return;
    kill(-self->id, SIGKILL);
    kill(self->id, SIGKILL); /* it may have joined another group */
    while (waitpid(self->id, &self->ended, 0) < 0 && errno == EINTR)
        ;
    bury(self);
}
