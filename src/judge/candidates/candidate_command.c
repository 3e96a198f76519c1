#include "candidate.h"
#include "child.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

/* What a line is allowed to be, with room for some words of the program's own. */
#define MOST_TEXT(lines) ((size_t)(lines)*CASE_LINE_MAX + 65536)

/* A program leaks when its data grows while it answers, again and again, by more than the least
 * that an allocation takes for each case. */
#define LEAST_GROWTHS 4
#define LEAST_GROWTH 16

typedef struct {
    candidate common;
    const char *command;
    double time_limit;
    int passes;        /* how often it is asked the cases */
    char *text;        /* the lines to be asked, twice */
    double start_time; /* of a life that is asked nothing */
} program;

/* The cases' lines, forwards, then perhaps backwards. */
static size_t write_text(program *self, const sure_case *cases, int count)
{
    char *end = self->text;
    for (int n = 0; n < self->passes * count; n++) {
        case_print(&cases[n < count ? n : 2 * count - 1 - n], end);
        end += strlen(end);
        *end++ = '\n';
    }
    return (size_t)(end - self->text);
}

static int count_lines(const pipe_result *from)
{
    int count = 0;
    for (size_t i = 0; i < from->length; i++)
        count += from->text[i] == '\n';
    return count + (from->length > 0 && from->text[from->length - 1] != '\n');
}

static void read_replies(const program *self, const pipe_result *from, reply *replies, int count)
{
    char *at = from->text;
    for (int n = 0; n < self->passes * count; n++) {
        reply given = reply_read(strsep(&at, "\n"));
        if (n < count) {
            replies[n] = given;
            continue;
        }
        reply *before = &replies[2 * count - 1 - n];
        before->changed = !reply_same(before, &given);
    }
}

static reply_kind kind_of(const program *self, const pipe_result *result, int count)
{
    bool ended = result->kind == REPLY_ANSWERED;
    if (result->kind == REPLY_UNASKED || (ended && result->ended != 0))
        return REPLY_CRASHED;
    return ended && count_lines(result) != self->passes * count ? REPLY_LOST : result->kind;
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
    int lines = result->kind == REPLY_LOST ? 0 : count_lines(result);
    return lines < count ? lines : count / 2;
}

static candidate_end ask(candidate *common, block *asked, int first, int count)
{
    program *self = (program *)common;
    size_t length = write_text(self, asked->cases + first, count);
    pipe_result result = pipe_run(self->command, self->text, length,
                                  MOST_TEXT(self->passes * count), self->time_limit);
    candidate_end end = {.kind = kind_of(self, &result, count), .ended = result.ended};
    if (end.kind == REPLY_ANSWERED) {
        read_replies(self, &result, asked->replies + first, count);
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

/* Can it be started, and does it answer line for line? An end that is its own doing is for the
 * verdict. */
static bool is_willing(program *self, char *message)
{
    pipe_result nothing = pipe_run(self->command, "", 0, MOST_TEXT(0), self->time_limit);
    bool ended = nothing.kind == REPLY_ANSWERED && WIFEXITED(nothing.ended);
    int status = ended ? WEXITSTATUS(nothing.ended) : 0, lines = count_lines(&nothing);
    self->start_time = nothing.nanoseconds;
    free(nothing.text);
    if (nothing.kind == REPLY_UNASKED || status == 126 || status == 127)
        return complain(message, "'%s' cannot be started", self->command);
    return lines == 0 ||
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
    self->time_limit = how->time_limit;
    self->passes = how->once ? 1 : 2;
    self->text = malloc((size_t)2 * BLOCK_CASES * CASE_LINE_MAX);
    if (!self->text || !is_willing(self, message)) {
        close_program(&self->common);
        return NULL;
    }
    return &self->common;
}
