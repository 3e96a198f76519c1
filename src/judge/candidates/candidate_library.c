/* SPDX-License-Identifier: MIT */
#include "candidate.h"
#include "child.h"
#include "plugin.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

typedef struct {
    candidate common;
    plugin_source from;
    char path[4096]; /* room for one */
    plugin_questions *questions;
    plugin_answers *answers;
    child process; /* the last one */
} library;

/* The child. */

static void *share(size_t size)
{
    void *at = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return at == MAP_FAILED ? NULL : at;
}

static void live_as_child(const void *context, int requests, int results)
{
    const library *self = context;
    mprotect(self->questions, sizeof *self->questions, PROT_READ);
    plugin_child(&self->from, self->questions, self->answers, requests, results);
}

/* Waits for its byte. It hangs when no call comes back for as long as the limit. */
static reply_kind wait_for_result(library *self, double limit)
{
    for (;;) {
        unsigned before = self->answers->progress;
        struct pollfd result = {.fd = self->process.output, .events = POLLIN};
        int ready = child_poll(&result, 1, (int)(limit * 1000) + 1);
        char byte;
        ssize_t done = ready > 0 ? read(self->process.output, &byte, 1) : -1;
        if (done == 1)
            return REPLY_ANSWERED;
        bool goes_on = ready == 0 ? self->answers->progress != before
                                  : ready < 0 || (done < 0 && errno == EINTR);
        if (goes_on)
            continue;
        /* It has closed its end, and may be about to end; or others hold it. */
        if (child_ends(&self->process, ready > 0 ? limit : 0, NULL))
            return REPLY_CRASHED;
        child_stop(&self->process);
        return REPLY_HUNG;
    }
}

/* What its process shares the library can spoil, at any moment: copies are looked at. */

static bool is_set(const bool *copy)
{
    unsigned char byte;
    memcpy(&byte, copy, sizeof byte);
    return byte != 0;
}

static void take_text(const char *shared, size_t size, char *to)
{
    memmove(to, shared, size);
    to[size - 1] = '\0';
    for (char *at = to; *at != '\0'; at++)
        *at = iscntrl((unsigned char)*at) ? '?' : *at;
}

static identity take_identity(const identity *shared)
{
    identity who;
    take_text(shared->name, sizeof who.name, who.name);
    take_text(shared->version, sizeof who.version, who.version);
    take_text(shared->build, sizeof who.build, who.build);
    return who;
}

/* A copy of a reply, whatever it was: an answer, or none. */
static void mend(reply *copy)
{
    bool answered =
        copy->kind == REPLY_ANSWERED &&
        (copy->status == SURE_MISS || copy->status == SURE_HIT || copy->status == SURE_INVALID);
    if (!answered && copy->kind != REPLY_GARBAGE)
        strcpy(copy->said, "spoilt");
    take_text(copy->said, sizeof copy->said, copy->said);
    copy->kind = answered ? REPLY_ANSWERED : REPLY_GARBAGE;
    copy->field = SURE_FIELD_NONE;
    copy->has_normal = is_set(&copy->has_normal);
    copy->touched = is_set(&copy->touched);
    copy->changed = is_set(&copy->changed);
    copy->leaked = is_set(&copy->leaked);
    copy->ended = 0;
}

/* The message of a child that could not load the library is its own. */
static bool is_loaded(library *self, char *message)
{
    const char *name = self->from.path ? self->from.path : sure_tier_name(self->from.tier);
    self->answers->message[0] = '\0';
    if (!child_start(&self->process, live_as_child, self))
        return complain(message, "no process for it: %s", strerror(errno));
    reply end = {.kind = wait_for_result(self, candidate_start_limit(&self->common))};
    char text[CASE_LINE_MAX];
    end.ended = self->process.ended;
    reply_print(&end, text);
    if (end.kind == REPLY_HUNG)
        return complain(message, "%s: it takes too long to be loaded", name);
    char said[CANDIDATE_MESSAGE];
    take_text(self->answers->message, sizeof said, said);
    if (*said != '\0')
        return complain(message, "%s", said);
    return end.kind == REPLY_ANSWERED ||
           complain(message, "%s: while it was loaded, %.256s", name, text);
}

/* Asking. */

static void write_question(plugin_questions *to, const sure_case *question, int i)
{
    double numbers[CASE_NUMBERS_MAX];
    int count = case_numbers(question->object.shape), fields = count - PLUGIN_RAY;
    case_to_numbers(question, numbers);
    for (int n = 0; n < count; n++) {
        plugin_numbers *of = n < PLUGIN_RAY ? &to->rays : &to->objects;
        int at = n < PLUGIN_RAY ? i * PLUGIN_RAY + n : i * fields + n - PLUGIN_RAY;
        if (to->in == PRECISION_FLOAT)
            of->of_float[at] = (float)numbers[n];
        else
            of->of_double[at] = numbers[n];
    }
}

static reply_kind ask_child(library *self)
{
    char byte = 0;
    self->answers->at = -1;
    if (self->process.id == 0 && !is_loaded(self, NULL))
        return REPLY_CRASHED;
    (void)!write(self->process.input, &byte, 1); /* where it fails, the child has ended */
    return wait_for_result(self, self->common.time_limit);
}

/* A child that ended did so in the case `at`, if that is one of these. */
static candidate_end ask(candidate *common, block *asked, int first, int count)
{
    library *self = (library *)common;
    self->questions->shape = asked->shape;
    self->questions->asks = asked->asks;
    bool takes_it = self->from.path || tier_takes_floats(self->from.tier, asked->asks);
    self->questions->in =
        takes_it ? common->answers_in[asked->asks][asked->shape] : PRECISION_DOUBLE;
    self->questions->passes = self->from.path || asked->for_time ? 2 : 1;
    self->questions->count = count;
    for (int i = 0; i < count; i++)
        write_question(self->questions, &asked->cases[first + i], i);
    candidate_end end = {.kind = ask_child(self)};
    end.ended = self->process.ended;
    const int at = self->answers->at; /* the routine can spoil what its process shares */
    end.surely = at >= 0 && at < count;
    end.blamed = end.surely ? first + at : -1;
    if (end.kind != REPLY_ANSWERED)
        return end;
    memcpy(asked->replies + first, self->answers->replies, (size_t)count * sizeof *asked->replies);
    for (int i = first; i < first + count; i++)
        mend(&asked->replies[i]);
    asked->nanoseconds += fmax(self->answers->nanoseconds, 0); /* 0 for a NaN, too */
    asked->building += fmax(self->answers->building, 0);
    for (int i = first; i < first + count && !self->from.path; i++) {
        const sure_case *question = &asked->cases[i];
        if (asked->replies[i].status == SURE_INVALID)
            asked->replies[i].field = sure_object_check(&question->ray, &question->object);
    }
    return end;
}

/* Opening and closing. */

static void close_library(candidate *common)
{
    library *self = (library *)common;
    child_stop(&self->process);
    if (self->questions)
        munmap(self->questions, sizeof *self->questions);
    if (self->answers)
        munmap(self->answers, sizeof *self->answers);
    free(self);
}

/* Its own conditions unless others were said. */
static bool choose_entry(library *self, const char *words, char *message)
{
    char own[CANDIDATE_MESSAGE];
    take_text(self->answers->entry, sizeof own, own);
    const char *expected = entry_read(words ? words : own, &self->common.entry);
    if (self->common.is_tier && self->common.entry.wall)
        return complain(message, "tier %s: of the entry 'wall' nothing: it has solids",
                        sure_tier_name(self->from.tier));
    return !expected || complain(message, "%s: sure_candidate_entry '%s': expected words %s",
                                 self->from.path, own, expected);
}

/* By the functions that there are; a tier takes either. */
static void choose_functions(library *self, candidate_inputs inputs)
{
    bool is_float = !self->from.path && self->from.tier == SURE_TIER_FLOAT32;
    for (int i = 0; i < QUERIES * SURE_SHAPES; i++) {
        int asked = i / SURE_SHAPES, shape = i % SURE_SHAPES;
        const bool *has = self->answers->has[asked][shape];
        bool single = inputs == INPUTS_FLOAT || (inputs == INPUTS_AS_IT_TAKES &&
                                                 (is_float || !is_set(&has[PRECISION_DOUBLE])));
        self->common.answers_in[asked][shape] = single ? PRECISION_FLOAT : PRECISION_DOUBLE;
        self->common.answers[asked][shape] =
            is_set(&has[single ? PRECISION_FLOAT : PRECISION_DOUBLE]);
    }
}

/* dlopen looks for a name without a slash elsewhere. */
static const char *with_slash(library *self, const char *path)
{
    if (!path || strchr(path, '/'))
        return path;
    snprintf(self->path, sizeof self->path, "./%s", path);
    return self->path;
}

static candidate *open_library(plugin_source from, const candidate_options *how, char *message)
{
    library *self = calloc(1, sizeof *self);
    complain(message, "no memory");
    if (!self)
        return NULL;
    self->common = (candidate){.block_cases = PLUGIN_BLOCK,
                               .is_tier = !from.path,
                               .is_quick = true,
                               .ask = ask,
                               .close = close_library};
    self->from = from;
    self->from.path = with_slash(self, from.path);
    self->common.time_limit = how->time_limit;
    self->questions = share(sizeof *self->questions);
    self->answers = share(sizeof *self->answers);
    signal(SIGPIPE, SIG_IGN);
    if (!self->questions || !self->answers || !is_loaded(self, message) ||
        !choose_entry(self, how->entry, message)) {
        close_library(&self->common);
        return NULL;
    }
    choose_functions(self, how->inputs);
    self->common.who = take_identity(&self->answers->who);
    return &self->common;
}

candidate *candidate_of_library(const char *path, const candidate_options *how, char *message)
{
    return open_library((plugin_source){.path = path}, how, message);
}

candidate *candidate_of_tier(sure_tier tier, bool with_normals, const candidate_options *how,
                             char *message)
{
    return open_library((plugin_source){NULL, tier, with_normals}, how, message);
}
