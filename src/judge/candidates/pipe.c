/* SPDX-License-Identifier: MIT */
#include "pipe.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#define CHUNK 65536

typedef struct {
    child *process;
    const char *text;
    size_t length, written;
    pipe_result *result;
    FILE *kept; /* what it wrote */
    size_t taken, most;
    double least, last; /* memory */

    bool goes_on; /* after this answer: */
    size_t bytes; /* it is so long; 0: as far as an empty line */
    size_t line;  /* where the last line begins that was looked at */
    bool whole;
} conversation;

/* Without a shell between, where nothing in the command is for one: the program is then the child
 * itself, whose memory can be watched. */
static void execute(const char *command)
{
    char *words[64];
    int count = 0;
    char *copy = strdup(command);
    bool plain = command[strcspn(command, "|&;<>()$`\\\"'*?[]#~=%{}!\n\t")] == '\0';
    char *word = copy ? strtok(copy, " ") : NULL;
    for (; word && count < 63; word = strtok(NULL, " "))
        words[count++] = word;
    words[count] = NULL;
    bool direct = plain && copy && !word; /* it has no more words */
    if (direct && count > 0)
        execvp(words[0], words);
    bool own = count > 0 && errno == ENOENT && !strchr(words[0], '/'); /* the shell's, maybe */
    if (!direct || own)
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
}

static void become(const void *command, int input, int output)
{
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0)
        execute(command);
    _exit(127);
}

bool pipe_open(child *process, const char *command)
{
    signal(SIGPIPE, SIG_IGN);
    if (!child_start(process, become, command))
        return false;
    fcntl(process->input, F_SETFL, O_NONBLOCK);
    return true;
}

static void give(conversation *with)
{
    size_t left = with->length - with->written;
    ssize_t done =
        write(with->process->input, with->text + with->written, left < CHUNK ? left : CHUNK);
    if (done > 0)
        with->written += (size_t)done;
    bool refused = done < 0 && errno != EAGAIN && errno != EINTR;
    if (refused || (with->written == with->length && !with->goes_on))
        child_close_input(with->process);
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
    if (with->goes_on)
        return;
    double now = memory_of(with->process->id);
    if (now == 0)
        return;
    if (with->least == 0)
        with->least = with->last = now;
    with->result->growths += now > with->last;
    with->last = now;
    with->result->growth = now - with->least;
}

/* Whoever goes on: is the answer all there? */
static bool is_whole(conversation *with)
{
    const pipe_result *result = with->result;
    if (!with->goes_on || fflush(with->kept) != 0)
        return false;
    if (with->bytes > 0)
        return result->length >= with->bytes;
    const char *line = result->text + with->line, *end;
    for (; (end = strchr(line, '\n')) != NULL; line = end + 1) {
        if (end == line || (end == line + 1 && *line == '\r'))
            return true;
    }
    with->line = (size_t)(line - result->text);
    return false;
}

/* A byte 0 is no text, and ends none: what is shown for it makes garbage of its line. */
static void show_zeros(char *chunk, size_t length)
{
    for (char *at = chunk; (at = memchr(at, '\0', length - (size_t)(at - chunk))) != NULL;)
        *at = '?';
}

/* False when it has closed its end, or it is enough. */
static bool take(conversation *with)
{
    char chunk[CHUNK];
    reply_kind *kind = &with->result->kind;
    ssize_t done = read(with->process->output, chunk, sizeof chunk);
    if (done <= 0)
        return done < 0 && errno == EINTR;
    with->taken += (size_t)done;
    if (with->bytes == 0)
        show_zeros(chunk, (size_t)done);
    watch_memory(with);
    if (fwrite(chunk, 1, (size_t)done, with->kept) < (size_t)done)
        *kind = REPLY_UNASKED;
    else if (with->taken > with->most)
        *kind = REPLY_LOST;
    with->whole = *kind == REPLY_ANSWERED && is_whole(with);
    return *kind == REPLY_ANSWERED && !with->whole;
}

static void talk(conversation *with, double time_limit)
{
    const child *process = with->process;
    for (;;) {
        struct pollfd both[2] = {{.fd = process->output, .events = POLLIN},
                                 {.fd = process->input, .events = POLLOUT}};
        bool gives = process->input >= 0 && (with->written < with->length || !with->goes_on);
        int ready = child_poll(both, gives ? 2 : 1, (int)(time_limit * 1000) + 1);
        if (ready == 0) {
            with->result->kind = REPLY_HUNG;
            return;
        }
        if (ready < 0)
            continue;
        if (gives && both[1].revents != 0)
            give(with);
        if (both[0].revents != 0 && !take(with))
            return;
    }
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
    if (result->kind == REPLY_ANSWERED && !child_ends(with->process, time_limit, &used))
        result->kind = REPLY_HUNG;
    child_stop(with->process);
    result->ended = with->process->ended;
    result->nanoseconds = nanoseconds_of(&used);
}

/* All of it, with a process that has been started. */
static void converse(conversation *with, double time_limit)
{
    pipe_result *result = with->result;
    result->kind = REPLY_ANSWERED;
    with->kept = open_memstream(&result->text, &result->length);
    if (with->kept)
        talk(with, time_limit);
    else
        result->kind = REPLY_UNASKED;
    if (!with->whole)
        finish(with, time_limit);
    if (with->kept && fclose(with->kept) != 0)
        result->kind = REPLY_UNASKED;
}

pipe_result pipe_run(const char *command, const char *text, size_t length, size_t most,
                     double time_limit)
{
    child process;
    pipe_result result = {.kind = REPLY_UNASKED};
    conversation with = {
        .process = &process, .text = text, .length = length, .result = &result, .most = most};
    if (pipe_open(&process, command))
        converse(&with, time_limit);
    return result;
}

/* That a process has computed, without its children. */
static double time_of_process(pid_t id)
{
    clockid_t clock;
    struct timespec now = {0};
    if (clock_getcpuclockid(id, &clock) != 0 || clock_gettime(clock, &now) != 0)
        return 0;
    return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

pipe_result pipe_ask(child *process, const char *text, size_t length, size_t bytes, size_t most,
                     double time_limit)
{
    pipe_result result = {.kind = REPLY_UNASKED};
    conversation with = {.process = process,
                         .text = text,
                         .length = length,
                         .result = &result,
                         .most = most,
                         .goes_on = true,
                         .bytes = bytes};
    double before = time_of_process(process->id);
    converse(&with, time_limit);
    if (with.whole)
        result.nanoseconds = time_of_process(process->id) - before;
    return result;
}
