#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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

static void close_input(child *self)
{
    if (self->input >= 0)
        close(self->input);
    self->input = -1;
}

void child_bury(child *self)
{
    close_input(self);
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

/* A command on a pipe. */

#define CHUNK 65536

typedef struct {
    child process;
    const char *text;
    size_t length, written;
    pipe_result *result;
    FILE *kept; /* what it wrote */
    size_t taken, most;
    double least, last; /* memory */
} conversation;

/* Without a shell between, where nothing in the command is for one: the program is then the child
 * itself, whose memory can be watched. */
static void execute(const char *command)
{
    char *words[64];
    int count = 0;
    if (command[strcspn(command, "|&;<>()$`\\\"'*?[]#~=%{}!\n\t")] != '\0')
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
    for (char *word = strtok(strdup(command), " "); word && count < 63; word = strtok(NULL, " "))
        words[count++] = word;
    words[count] = NULL;
    if (count > 0)
        execvp(words[0], words);
}

static void become(const void *command, int input, int output)
{
    setpgid(0, 0); /* so that it can be ended with its children */
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0)
        execute(command);
    _exit(127);
}

static bool start(conversation *with, const char *command)
{
    if (!child_start(&with->process, become, command))
        return false;
    setpgid(with->process.id, with->process.id);
    fcntl(with->process.input, F_SETFL, O_NONBLOCK);
    return true;
}

static void give(conversation *with)
{
    size_t left = with->length - with->written;
    ssize_t done =
        write(with->process.input, with->text + with->written, left < CHUNK ? left : CHUNK);
    if (done > 0)
        with->written += (size_t)done;
    bool refused = done < 0 && errno != EAGAIN && errno != EINTR;
    if (with->written == with->length || refused)
        close_input(&with->process);
}

/* The bytes of its data, where the system tells. */
static double memory_of(pid_t id)
{
    char path[64];
    unsigned long data = 0;
    snprintf(path, sizeof path, "/proc/%ld/statm", (long)id);
    FILE *in = fopen(path, "r");
    if (!in)
        return 0;
    if (fscanf(in, "%*u %*u %*u %*u %*u %lu", &data) != 1)
        data = 0;
    fclose(in);
    return (double)data * (double)sysconf(_SC_PAGESIZE);
}

static void watch_memory(conversation *with)
{
    double now = memory_of(with->process.id);
    if (now == 0)
        return;
    if (with->least == 0)
        with->least = with->last = now;
    with->result->growths += now > with->last;
    with->last = now;
    with->result->growth = now - with->least;
}

/* False when it has closed its end, or it is enough. */
static bool take(conversation *with)
{
    char chunk[CHUNK];
    reply_kind *kind = &with->result->kind;
    ssize_t done = read(with->process.output, chunk, sizeof chunk);
    if (done <= 0)
        return done < 0 && errno == EINTR;
    with->taken += (size_t)done;
    watch_memory(with);
    if (fwrite(chunk, 1, (size_t)done, with->kept) < (size_t)done)
        *kind = REPLY_UNASKED;
    else if (with->taken > with->most)
        *kind = REPLY_LOST;
    return *kind == REPLY_ANSWERED;
}

static void talk(conversation *with, double time_limit)
{
    for (;;) {
        struct pollfd both[2] = {{.fd = with->process.output, .events = POLLIN},
                                 {.fd = with->process.input, .events = POLLOUT}};
        int ready = poll(both, with->process.input >= 0 ? 2 : 1, (int)(time_limit * 1000) + 1);
        if (ready == 0) {
            with->result->kind = REPLY_HUNG;
            return;
        }
        if (ready < 0)
            continue;
        if (with->process.input >= 0 && both[1].revents != 0)
            give(with);
        if (both[0].revents != 0 && !take(with))
            return;
    }
}

/* It has closed its output; is it ending? */
static bool ends_soon(pid_t id, double time_limit, int *ended, struct rusage *used)
{
    for (double waited = 0; waited < time_limit; waited += 0.001) {
        if (wait4(id, ended, WNOHANG, used) == id)
            return true;
        poll(NULL, 0, 1);
    }
    return false;
}

static double nanoseconds_of(const struct rusage *used)
{
    double seconds = (double)used->ru_utime.tv_sec + (double)used->ru_stime.tv_sec;
    return seconds * 1e9 + 1e3 * ((double)used->ru_utime.tv_usec + (double)used->ru_stime.tv_usec);
}

static void finish(conversation *with, double time_limit)
{
    pipe_result *result = with->result;
    struct rusage used = {0};
    close_input(&with->process);
    close(with->process.output);
    pid_t id = with->process.id;
    if (result->kind != REPLY_ANSWERED || !ends_soon(id, time_limit, &result->ended, &used)) {
        if (result->kind == REPLY_ANSWERED)
            result->kind = REPLY_HUNG;
        kill(-id, SIGKILL);
        while (wait4(id, &result->ended, 0, &used) < 0 && errno == EINTR)
            ;
    }
    result->nanoseconds = nanoseconds_of(&used);
}

pipe_result pipe_run(const char *command, const char *text, size_t length, size_t most,
                     double time_limit)
{
    pipe_result result = {.kind = REPLY_ANSWERED};
    conversation with = {.text = text, .length = length, .result = &result, .most = most};
    signal(SIGPIPE, SIG_IGN);
    with.kept = open_memstream(&result.text, &result.length);
    bool started = with.kept && start(&with, command);
    if (started) {
        talk(&with, time_limit);
        finish(&with, time_limit);
    }
    if (!with.kept || fclose(with.kept) != 0 || !started)
        result.kind = REPLY_UNASKED;
    return result;
}
