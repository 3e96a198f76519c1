/* What every process that the judge starts does first. Define _DEFAULT_SOURCE before. */
#ifndef JUDGE_CHILD_H
#define JUDGE_CHILD_H

#include <signal.h>
#include <sys/resource.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

/* A crash leaves no file behind, a hang not even itself when the judge is interrupted, and a pipe
 * that nobody reads ends it as usual. */
static inline void child_begins(void)
{
    const struct rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    signal(SIGPIPE, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

#endif
