/* SPDX-License-Identifier: MIT */
#include "candidate.h"
#include "exchange.h"
#include "pipe.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

/* A program leaks when its data grows while it answers, again and again, by more than the least
 * that an allocation takes for each case. */
#define LEAST_GROWTHS 4
#define LEAST_GROWTH 16

typedef struct {
    candidate common;
    const char *command;
    int passes;        /* how often it is asked the cases */
    char *text;        /* the lines to be asked, twice */
    double start_time; /* of a life that is asked nothing */
} program;

static int lines_of(const pipe_result *from)
{
    return count_lines(from->text, from->length);
}

static reply_kind kind_of(const program *self, const pipe_result *result, int count)
{
    bool ended = result->kind == REPLY_ANSWERED;
    if (result->kind == REPLY_UNASKED || (ended && result->ended != 0))
        return REPLY_CRASHED;
    return ended && lines_of(result) != self->passes * count ? REPLY_LOST : result->kind;
}

static bool leaks(const program *self, const pipe_result *result, int count)
{
    double answers = (double)self->passes * count;
    return result->growths >= LEAST_GROWTHS && result->growth >= answers * LEAST_GROWTH;
}

/* How many cases it seems to have answered before it ended: all, where it does not hold lines back.
 */
static int seemingly_answered(const pipe_result *result, int count)
{
    int lines = result->kind == REPLY_LOST ? 0 : lines_of(result);
    return lines < count ? lines : count / 2;
}

static candidate_end ask(candidate *common, block *asked, int first, int count)
{
    program *self = (program *)common;
    exchange of = {asked->cases + first, count, false, asked->asks == QUERY_INTERVAL};
    size_t length = 0;
    for (int pass = 0; pass < self->passes; pass++) {
        of.again = pass > 0;
        length += exchange_lines(&of, self->text + length);
    }
    pipe_result result = pipe_run(self->command, self->text, length,
                                  MOST_TEXT(self->passes * count), self->common.time_limit);
    candidate_end end = {.kind = kind_of(self, &result, count), .ended = result.ended};
    if (end.kind == REPLY_ANSWERED) {
        char *at = result.text;
        for (int pass = 0; pass < self->passes; pass++) {
            of.again = pass > 0;
            replies_from_lines(&of, &at, asked->replies + first);
        }
        asked->replies[first].leaked = leaks(self, &result, count);
        asked->nanoseconds += (result.nanoseconds - self->start_time) / self->passes;
    } else {
        end.blamed = first + seemingly_answered(&result, count);
    }
    free(result.text);
    return end;
}

static void close_program(candidate *common)
{
    program *self = (program *)common;
    free(self->text);
    free(self);
}

/* Can it be started, and does it answer line for line? An empty line is an answer to no case, too.
 * An end that is its own doing is for the verdict. */
static bool is_willing(program *self, char *message)
{
    pipe_result nothing = pipe_run(self->command, "", 0, MOST_TEXT(0), self->common.time_limit);
    bool ended = nothing.kind == REPLY_ANSWERED && WIFEXITED(nothing.ended);
    int status = ended ? WEXITSTATUS(nothing.ended) : 0, lines = lines_of(&nothing);
    bool empty = !nothing.text || nothing.text[strspn(nothing.text, "\r\n")] == '\0';
    self->start_time = nothing.nanoseconds;
    free(nothing.text);
    if (nothing.kind == REPLY_UNASKED || status == 126 || status == 127)
        return complain(message, "'%s' cannot be started", self->command);
    return (lines <= 1 && empty) ||
           complain(message, "'%s' is out of step: %d lines for no case", self->command, lines);
}

candidate *candidate_of_command(const char *command, const candidate_options *how, char *message)
{
    program *self = calloc(1, sizeof *self);
    complain(message, "no memory");
    if (!self)
        return NULL;
    self->common = candidate_by_lines(how);
    self->common.ask = ask;
    self->common.close = close_program;
    self->command = command;
    self->passes = how->once ? 1 : 2;
    self->text = malloc((size_t)2 * BLOCK_CASES * CASE_LINE_MAX);
    if (!self->text || !is_willing(self, message)) {
        close_program(&self->common);
        return NULL;
    }
    return &self->common;
}
