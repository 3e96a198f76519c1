/* SPDX-License-Identifier: MIT */
#include "candidate.h"
#include "exchange.h"
#include "pipe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#define KEPT_BLOCK 512 /* in numbers no more than a pipe holds */
#define KEPT_PASSES 2

typedef struct {
    candidate common;
    const char *command;
    bool by_numbers;
    child process;
    char text[KEPT_BLOCK * CASE_LINE_MAX]; /* what it is told */
} program;

/* Its start. */

/* Its first words are in `greeting`, unless it ended, said too much or nothing for too long. */
static candidate_end start(program *self, char greeting[CANDIDATE_MESSAGE])
{
    candidate_end end = {.kind = REPLY_CRASHED, .blamed = -1};
    if (!pipe_open(&self->process, self->command))
        return end;
    pipe_result said = pipe_ask(&self->process, NULL, 0, 0, CANDIDATE_MESSAGE - 1,
                                candidate_start_limit(&self->common));
    bool ended = said.kind == REPLY_ANSWERED && self->process.id == 0;
    end.kind = ended ? REPLY_CRASHED : said.kind;
    end.ended = said.ended;
    if (end.kind == REPLY_ANSWERED)
        memcpy(greeting, said.text, said.length + 1);
    free(said.text);
    return end;
}

static bool add_shape(const char *word, bool shapes[SURE_SHAPES])
{
    bool known = false;
    for (int i = 0; i < SURE_SHAPES; i++) {
        bool named = strcmp(word, sure_shape_name((sure_shape)i)) == 0;
        shapes[i] |= named;
        known |= named;
    }
    return known;
}

/* The shapes that it answers (none: all), and its entry conditions unless others were said. */
static bool describe(program *self, const candidate_options *how, const bool *shapes,
                     const char *conditions, char *message)
{
    candidate_options chosen = *how;
    if (!chosen.entry)
        chosen.entry = conditions;
    const char *expected = entry_read(chosen.entry, &(entry){0});
    if (expected)
        return complain(message, "'%s' says '%s': expected binary, shapes, or words %s",
                        self->command, conditions, expected);
    self->common = candidate_by_lines(&chosen);
    bool all = memchr(shapes, true, SURE_SHAPES) == NULL;
    for (int i = 0; i < SURE_SHAPES; i++)
        self->common.answers[QUERY_HIT][i] = all || shapes[i];
    return true;
}

/* `name=Bullet`, `version=3.24`, `build=...` */
static bool add_name(const char *word, identity *who)
{
    const struct {
        const char *key;
        char *to;
        size_t room;
    } names[] = {{"name=", who->name, sizeof who->name},
                 {"version=", who->version, sizeof who->version},
                 {"build=", who->build, sizeof who->build}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        size_t length = strlen(names[i].key);
        if (strncmp(word, names[i].key, length) != 0)
            continue;
        snprintf(names[i].to, names[i].room, "%s", word + length);
        return true;
    }
    return false;
}

/* `ready`, and what it says of itself, in any order. */
static bool greet(program *self, const candidate_options *how, char *message)
{
    char greeting[CANDIDATE_MESSAGE] = "", conditions[CANDIDATE_MESSAGE + 1] = "";
    char *rest = greeting, *word;
    bool ready = false, shapes[SURE_SHAPES] = {false};
    identity who = {.name = ""};
    candidate_end end = start(self, greeting);
    int status = WIFEXITED(end.ended) ? WEXITSTATUS(end.ended) : 0;
    if (status == 126 || status == 127)
        return complain(message, "'%s' cannot be started", self->command);
    while ((word = strsep(&rest, " \t\r\n")) != NULL) {
        if (strcmp(word, "ready") == 0)
            ready = true;
        else if (strcmp(word, "binary") == 0)
            self->by_numbers = true;
        else if (*word != '\0' && !add_shape(word, shapes) && !add_name(word, &who))
            sprintf(conditions + strlen(conditions), "%s ", word);
    }
    if (!ready)
        return complain(message, "'%s' does not say 'ready' and an empty line (docs/coprocess.md)",
                        self->command);
    bool described = describe(self, how, shapes, conditions, message);
    self->common.who = who;
    return described;
}

/* Asking. */

/* The answers of a pass, and how many there seem to be where it has ended. */
static candidate_end ask_pass(program *self, const exchange *of, reply *replies, double *least)
{
    const size_t count = (size_t)of->count, answers = count * EXCHANGE_ANSWER * sizeof(double);
    const bool numbers = self->by_numbers;
    size_t length = numbers ? exchange_numbers(of, self->text) : exchange_lines(of, self->text);
    if (!numbers)
        self->text[length++] = '\n';
    pipe_result said = pipe_ask(&self->process, self->text, length, numbers ? answers : 0,
                                numbers ? answers : MOST_TEXT(of->count), self->common.time_limit);
    candidate_end end = {.kind = said.kind, .ended = said.ended, .blamed = -1};
    bool lives = said.kind == REPLY_ANSWERED && self->process.id != 0;
    bool in_step = numbers || count_lines(said.text, said.length) == of->count + 1;
    if (said.kind == REPLY_UNASKED || (said.kind == REPLY_ANSWERED && said.ended != 0))
        end.kind = REPLY_CRASHED;
    else if (said.kind == REPLY_ANSWERED && !(lives && in_step))
        end.kind = REPLY_LOST;
    char *at = said.text;
    if (end.kind == REPLY_ANSWERED && numbers)
        replies_from_numbers(of, at, replies);
    else if (end.kind == REPLY_ANSWERED)
        replies_from_lines(of, &at, replies);
    *least = fmin(*least, said.nanoseconds);
    free(said.text);
    return end;
}

/* Forwards, and backwards. */
static candidate_end ask_once(program *self, block *asked, int first, int count, double *least)
{
    char greeting[CANDIDATE_MESSAGE];
    candidate_end end = {.kind = REPLY_ANSWERED};
    if (self->process.id == 0)
        end = start(self, greeting);
    for (int pass = 0; pass < KEPT_PASSES && end.kind == REPLY_ANSWERED; pass++) {
        const exchange of = {.cases = asked->cases + first, .count = count, .again = pass > 0};
        end = ask_pass(self, &of, asked->replies + first, least);
    }
    if (end.kind != REPLY_ANSWERED)
        child_stop(&self->process);
    return end;
}

/* One by one, which takes but one more start. Who answers all of them in time was slow, and is
 * asked fewer at once from now on. */
static candidate_end ask_each(program *self, block *asked, int first, int count,
                              const candidate_end *before)
{
    candidate_end end = *before;
    double unused = INFINITY;
    for (int i = first; i < first + count; i++) {
        candidate_end alone = ask_once(self, asked, i, 1, &unused);
        if (alone.kind == REPLY_ANSWERED)
            continue;
        alone.blamed = i;
        alone.surely = true;
        return alone;
    }
    if (end.kind != REPLY_HUNG)
        return end;
    candidate_is_slow(&self->common, asked, count);
    end.kind = REPLY_ANSWERED;
    return end;
}

static candidate_end ask(candidate *common, block *asked, int first, int count)
{
    program *self = (program *)common;
    double least = INFINITY;
    candidate_end end = ask_once(self, asked, first, count, &least);
    if (end.kind != REPLY_ANSWERED && count > 1)
        return ask_each(self, asked, first, count, &end);
    if (end.kind == REPLY_ANSWERED)
        asked->nanoseconds += least;
    return end;
}

static void close_program(candidate *common)
{
    program *self = (program *)common;
    child_stop(&self->process);
    free(self);
}

candidate *candidate_of_kept(const char *command, const candidate_options *how, char *message)
{
    program *self = calloc(1, sizeof *self);
    complain(message, "no memory");
    if (!self)
        return NULL;
    self->command = command;
    self->common.time_limit = how->time_limit;
    if (!greet(self, how, message)) {
        child_stop(&self->process);
        free(self);
        return NULL;
    }
    self->common.block_cases = KEPT_BLOCK;
    self->common.is_quick = true;
    self->common.ask = ask;
    self->common.close = close_program;
    return &self->common;
}
